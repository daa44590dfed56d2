#include "sections/path_settling.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "aisle/core/angle.hpp"
#include "corridor_run.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

/// A corridor 1.8 m wide that turns left once; the floor is on the left of every wall.
constexpr double kCornerBend_m = 0.6, kCornerLeg_m = 4, kHalfWidth_m = 0.9;
const std::array<Segment2, 4> kCornerWalls = {
    Segment2{{-1, -kHalfWidth_m}, {kCornerLeg_m + kCornerBend_m + kHalfWidth_m, -kHalfWidth_m}},
    Segment2{{kCornerLeg_m + kCornerBend_m + kHalfWidth_m, -kHalfWidth_m},
             {kCornerLeg_m + kCornerBend_m + kHalfWidth_m, 8}},
    Segment2{{kCornerLeg_m + kCornerBend_m - kHalfWidth_m, 8},
             {kCornerLeg_m + kCornerBend_m - kHalfWidth_m, kHalfWidth_m}},
    Segment2{{kCornerLeg_m + kCornerBend_m - kHalfWidth_m, kHalfWidth_m}, {-1, kHalfWidth_m}}};

SensedSegment floor_edge(const Vec2& p_vehicle_start, const Vec2& p_vehicle_end) {
  SensedSegment edge;
  edge.segment = {p_vehicle_start, p_vehicle_end};
  edge.centroid = (p_vehicle_start + p_vehicle_end) / 2;
  edge.heading_rad = heading_of(p_vehicle_end - p_vehicle_start);
  edge.length_m = (p_vehicle_end - p_vehicle_start).norm();
  edge.sigma_offset_m = 0.02;
  edge.sigma_heading_rad = 1 * kDegree;
  return edge;
}

/// The parts of the walls 0.6 to 3 m ahead, exactly where they are.
std::vector<SensedSegment> corner_seen_from(const Pose2& T_route_vehicle) {
  std::vector<SensedSegment> edges;
  for (const Segment2& wall : kCornerWalls) {
    const Vec2 start = T_route_vehicle.inverse() * wall.start, end = T_route_vehicle.inverse() * wall.end;
    if (cross(end - start, -start) <= 0) continue;
    double from = 0, to = 1;
    const auto clip = [&](double at_start, double at_end) {  // keeps what is positive
      if (at_start <= 0 && at_end <= 0) to = -1;
      const double zero = at_start / (at_start - at_end);
      if (at_start < 0 && at_end > 0) from = std::max(from, zero);
      if (at_start > 0 && at_end < 0) to = std::min(to, zero);
    };
    clip(start.x() - 0.6, end.x() - 0.6);
    clip(3 - start.x(), 3 - end.x());
    clip(2.5 - start.y(), 2.5 - end.y());
    clip(start.y() + 2.5, end.y() + 2.5);
    const Vec2 along = end - start;
    if ((to - from) * along.norm() > 0.3)
      edges.push_back(floor_edge(start + from * along, start + to * along));
  }
  return edges;
}

OdometryReading reading_of(const Arc& arc) {
  if (arc.length_m == 0) return FrontSteeredMotion{};
  const double steering_rad =
      std::atan(corridor_cart().front_steered.wheelbase_m * arc.turn_rad / arc.length_m);
  return FrontSteeredMotion{arc.length_m / std::cos(steering_rad), steering_rad};
}

struct CornerDrive {
  std::vector<SectionCycle> cycles;
  std::vector<Pose2> T_route_vehicle;  ///< the truth
  std::vector<DrivenPathSegment> path_segments;

  std::vector<Pose2> settled(const std::vector<double>& headings_rad) const {
    return settled_path(cycles, corridor_cart(), headings_rad, path_segments);
  }
  std::vector<double> headings_rad() const {
    std::vector<double> headings_rad;
    for (const Pose2& T : T_route_vehicle) headings_rad.push_back(T.theta);
    return headings_rad;
  }
  /// What the odometry alone gives.
  std::vector<Pose2> T_route_read() const {
    std::vector<Pose2> path = {Pose2{}};
    for (std::size_t i = 1; i < cycles.size(); ++i)
      path.push_back(path.back() *
                     drive(corridor_cart().front_steered, std::get<FrontSteeredMotion>(cycles[i].odometry)));
    return path;
  }
  std::vector<double> read_headings_rad() const {
    std::vector<double> headings_rad;
    for (const Pose2& T : T_route_read()) headings_rad.push_back(T.theta);
    return headings_rad;
  }
};

/// Around the corner in the middle of the corridor.
/// @param misread  what the odometry reports of a motion; absent: the motion
CornerDrive around_corner(const std::function<Arc(const Arc&)>& misread = nullptr) {
  CornerDrive drive;
  Pose2 T_route_vehicle;
  const auto go = [&](double length_m, double turn_rad) {
    const int steps = static_cast<int>(std::lround(length_m / 0.08));
    for (int i = 0; i < steps; ++i) {
      const Arc arc{length_m / steps, turn_rad / steps};
      T_route_vehicle = T_route_vehicle * end_pose(arc);
      drive.T_route_vehicle.push_back(T_route_vehicle);
      drive.cycles.push_back({.stamp_s = 0.1 * static_cast<double>(drive.cycles.size()),
                              .odometry = reading_of(misread ? misread(arc) : arc),
                              .floor_edges = corner_seen_from(T_route_vehicle)});
    }
  };
  drive.T_route_vehicle.push_back(T_route_vehicle);
  drive.cycles.push_back(
      {.odometry = FrontSteeredMotion{}, .floor_edges = corner_seen_from(T_route_vehicle)});
  go(kCornerLeg_m, 0);
  drive.path_segments.push_back({0, drive.cycles.size(), 0});
  go(kCornerBend_m * kPi / 2, kPi / 2);
  const std::size_t first = drive.cycles.size() - 1;
  go(kCornerLeg_m, 0);
  drive.path_segments.push_back({first, drive.cycles.size(), kPi / 2});
  return drive;
}

/// The wheels point farther left than they say.
Arc misread_by_bias(const Arc& arc) {
  return {arc.length_m, arc.turn_rad - 0.5 * kDegree / 0.75 * arc.length_m};
}

double worst_m(const std::vector<Pose2>& path, const std::vector<Pose2>& truth, std::size_t first = 0,
               std::size_t end = SIZE_MAX) {
  double worst_m = 0;
  for (std::size_t i = first; i < std::min(end, path.size()); ++i)
    worst_m = std::max(worst_m, (path[i].position() - truth[i].position()).norm());
  return worst_m;
}

double worst_rad(const std::vector<Pose2>& path, const std::vector<Pose2>& truth) {
  double worst_rad = 0;
  for (std::size_t i = 0; i < path.size(); ++i)
    worst_rad = std::max(worst_rad, std::abs(wrap_angle(path[i].theta - truth[i].theta)));
  return worst_rad;
}

TEST(PathSettling, NothingDrivenIsNoPath) {
  EXPECT_TRUE(settled_path({}, corridor_cart(), {}, {}).empty());
}

TEST(PathSettling, AnExactDriveStaysAsItIs) {
  const CornerDrive drive = around_corner();
  const std::vector<Pose2> path = drive.settled(drive.headings_rad());
  ASSERT_EQ(path.size(), drive.T_route_vehicle.size());
  EXPECT_LT(worst_m(path, drive.T_route_vehicle), 1e-9);
  EXPECT_LT(worst_rad(path, drive.T_route_vehicle), 1e-9);
}

TEST(PathSettling, WithoutAnyEdgeTheOdometryCountsWhateverTheFirstHeadings) {
  CornerDrive drive = around_corner(misread_by_bias);
  for (SectionCycle& cycle : drive.cycles) cycle.floor_edges.clear();
  std::vector<double> headings_rad = drive.headings_rad();
  for (std::size_t i = 0; i < headings_rad.size(); ++i)
    headings_rad[i] += 4 * kDegree * std::cos(0.3 * static_cast<double>(i));
  const std::vector<Pose2> path = drive.settled(headings_rad);
  EXPECT_LT(worst_m(path, drive.T_route_read()), 1e-6);
  EXPECT_LT(worst_rad(path, drive.T_route_read()), 1e-6);
}

RC_GTEST_PROP(PathSettling, FirstHeadingsThatAreOffBySomeDegreesDoNotMatter, (std::uint64_t seed)) {
  const CornerDrive drive = around_corner();
  Random random(seed);
  std::vector<double> headings_rad = drive.headings_rad();
  double off_rad = random.uniform(-2, 2) * kDegree;
  for (double& heading_rad : headings_rad) {
    off_rad = std::clamp(off_rad + random.normal(0.3 * kDegree), -4 * kDegree, 4 * kDegree);
    heading_rad += off_rad;
  }
  const std::vector<Pose2> path = drive.settled(headings_rad);
  RC_ASSERT(worst_m(path, drive.T_route_vehicle) < 1e-3);
  RC_ASSERT(worst_rad(path, drive.T_route_vehicle) < 0.02 * kDegree);
}

TEST(PathSettling, WallsStraightenADriveThatTheOdometryBends) {
  const CornerDrive drive = around_corner(misread_by_bias);
  EXPECT_GT(worst_m(drive.T_route_read(), drive.T_route_vehicle), 0.3);
  EXPECT_LT(worst_m(drive.settled(drive.read_headings_rad()), drive.T_route_vehicle), 0.02);
}

TEST(PathSettling, WhatIsSeenLaterCorrectsThePathBefore) {
  CornerDrive drive = around_corner(misread_by_bias);
  const std::size_t unseen = drive.path_segments[0].end;
  for (std::size_t i = 0; i < unseen; ++i) drive.cycles[i].floor_edges.clear();
  const double read_m = worst_m(drive.T_route_read(), drive.T_route_vehicle, 0, unseen);
  const std::vector<Pose2> path = drive.settled(drive.read_headings_rad());
  EXPECT_GT(read_m, 0.08);
  EXPECT_LT(worst_m(path, drive.T_route_vehicle, 0, unseen), read_m / 4);
}

/// Along the first corridor with a metre aslant, where no edges are seen and the wheels slip.
CornerDrive sidestep() {
  constexpr double kAslant_rad = 4 * kDegree, kFrom_m = 1, kStep_m = 0.08;
  CornerDrive drive = around_corner();
  drive.path_segments.resize(1);
  drive.cycles.resize(drive.path_segments[0].end);
  drive.T_route_vehicle.resize(1);
  double heading_rad = 0;
  for (std::size_t i = 1; i < drive.cycles.size(); ++i) {
    const double on_m = static_cast<double>(i) * kStep_m - kFrom_m;
    const bool is_aslant = on_m > 0 && on_m < 1;
    const double wanted_rad = is_aslant ? kAslant_rad * std::sin(on_m * kPi) : 0;
    const Arc arc{kStep_m, wanted_rad - std::exchange(heading_rad, wanted_rad)};
    drive.T_route_vehicle.push_back(drive.T_route_vehicle.back() * end_pose(arc));
    drive.cycles[i].floor_edges.clear();
    if (!is_aslant) drive.cycles[i].floor_edges = corner_seen_from(drive.T_route_vehicle.back());
  }
  return drive;
}

TEST(PathSettling, AWallBesideShowsASidestepThatItsDirectionDoesNot) {
  VehicleDescription vehicle = corridor_cart();
  vehicle.front_steered_noise.heading_slip_rad_per_sqrt_m = 5 * kDegree;  // a sidestep is likely
  const CornerDrive drive = sidestep();
  const auto lateral_off_m = [&](std::span<const DrivenPathSegment> path_segments) {
    const std::vector<Pose2> path =
        settled_path(drive.cycles, vehicle, drive.read_headings_rad(), path_segments);
    return std::abs(path.back().y - drive.T_route_vehicle.back().y);
  };
  const double sidestep_m = drive.T_route_vehicle.back().y;
  EXPECT_GT(sidestep_m, 0.04);
  EXPECT_NEAR(lateral_off_m({}), sidestep_m, 0.1 * sidestep_m);
  EXPECT_LT(lateral_off_m(drive.path_segments), 0.5 * sidestep_m);
}

TEST(PathSettling, AWallSeenElsewhereForAWhileHardlyMovesThePath) {
  constexpr double kOff_m = 0.3;
  CornerDrive drive = around_corner();
  for (std::size_t i = 15; i < 28; ++i) {
    for (SensedSegment& edge : drive.cycles[i].floor_edges) {
      if (edge.centroid.y() > 0) continue;
      for (Vec2* p : {&edge.segment.start, &edge.segment.end, &edge.centroid}) p->y() += kOff_m;
    }
  }
  EXPECT_LT(worst_m(drive.settled(drive.headings_rad()), drive.T_route_vehicle), 0.05 * kOff_m);
}

TEST(PathSettling, AMisalignedEdgeHardlyTurnsThePath) {
  constexpr double kOff_rad = 10 * kDegree;
  CornerDrive drive = around_corner();
  for (std::size_t i = 15; i < 28; ++i)
    drive.cycles[i].floor_edges.push_back(floor_edge({1, 0.3}, Vec2(1, 0.3) + unit(kOff_rad)));
  EXPECT_LT(worst_rad(drive.settled(drive.headings_rad()), drive.T_route_vehicle), 0.05 * kOff_rad);
}

SensedSegment in_mirror(SensedSegment edge) {
  const auto flip = [](const Vec2& p) { return Vec2(p.x(), -p.y()); };
  edge.segment = {flip(edge.segment.end), flip(edge.segment.start)};  // the sensor stays on its left
  edge.centroid = flip(edge.centroid);
  edge.heading_rad = wrap_angle(kPi - edge.heading_rad);
  return edge;
}

RC_GTEST_PROP(PathSettling, ADriveInTheMirrorIsSettledInTheMirror, (std::uint64_t seed)) {
  Random random(seed);
  CornerDrive drive = around_corner([&](const Arc& arc) {
    return Arc{arc.length_m, misread_by_bias(arc).turn_rad + random.normal(0.1 * kDegree)};
  });
  for (SectionCycle& cycle : drive.cycles) {
    for (SensedSegment& edge : cycle.floor_edges) {
      const double off_m = random.normal(0.02);
      edge.heading_rad += random.normal(1 * kDegree);
      for (Vec2* p : {&edge.segment.start, &edge.segment.end, &edge.centroid})
        *p += off_m * left_normal(unit(edge.heading_rad));
    }
  }
  CornerDrive mirrored = drive;
  for (SectionCycle& cycle : mirrored.cycles) {
    auto& motion = std::get<FrontSteeredMotion>(cycle.odometry);
    motion.steering_rad = -motion.steering_rad;
    for (SensedSegment& edge : cycle.floor_edges) edge = in_mirror(edge);
  }
  for (DrivenPathSegment& segment : mirrored.path_segments) segment.heading_rad = -segment.heading_rad;
  const std::vector<Pose2> path = drive.settled(drive.read_headings_rad());
  std::vector<Pose2> back = mirrored.settled(mirrored.read_headings_rad());
  for (Pose2& T : back) T = {T.x, -T.y, -T.theta};
  RC_ASSERT(worst_m(back, path) < 1e-6);
  RC_ASSERT(worst_rad(back, path) < 1e-6);
  RC_ASSERT(worst_m(path, drive.T_route_vehicle) < 0.05);
}

}  // namespace
}  // namespace aisle
