#include "walls/wall_adjustment.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/core/square.hpp"
#include "pose_matchers.hpp"
#include "walls/wall_residuals.hpp"

namespace aisle {
namespace {

constexpr double kSensorReach_m = 3.5;
constexpr int kWallRounds = 4;

/// A room with a cut-off corner; its inside is on the left of each wall.
const std::vector<Segment2> kCutRoom = {
    {{0, 0}, {8, 0}}, {{8, 0}, {8, 4}}, {{8, 4}, {6, 6}}, {{6, 6}, {0, 6}}, {{0, 6}, {0, 0}}};

struct DriveNoise {
  double step_m = 0, step_rad = 0;       ///< of each motion between keyframes
  double offset_m = 0, heading_rad = 0;  ///< of each segment
};

constexpr DriveNoise kUsualDrive{
    .step_m = 0.005, .step_rad = 0.15 * kDegree, .offset_m = 0.005, .heading_rad = 0.3 * kDegree};

/// A piece of a wall as seen from a pose, moved along its normal and turned about its middle.
SensedSegment sensed(const Segment2& wall_piece, const Pose2& T_map_sensor, double off_m, double off_rad) {
  const Segment2 exact = T_map_sensor.inverse() * wall_piece;
  const double heading_rad = exact.heading() + off_rad;
  SensedSegment result;
  result.length_m = exact.length();
  result.heading_rad = wrap_angle(heading_rad);
  result.centroid = exact.midpoint() + off_m * left_normal(unit(exact.heading()));
  const Vec2 half = result.length_m / 2 * unit(heading_rad);
  result.segment = {result.centroid - half, result.centroid + half};
  result.sigma_offset_m = 0.005;
  result.sigma_heading_rad = 0.3 * kDegree;
  return result;
}

/// Once around in the room, along an ellipse.
struct RoomDrive {
  std::vector<Pose2> truth;  ///< in the frame of the room
  std::vector<Keyframe> keyframes;
  ScanSegments segments;

  explicit RoomDrive(const DriveNoise& noise = {}, Random random = Random(1)) {
    constexpr int kKeyframes = 24;
    for (int k = 0; k < kKeyframes; ++k) {
      const double t = 2 * kPi * k / kKeyframes;
      truth.push_back({4 + 2.2 * std::cos(t), 3 + 1.6 * std::sin(t),
                       heading_of(Vec2(-2.2 * std::sin(t), 1.6 * std::cos(t)))});
    }
    Pose2 T_track_sensor = truth.front();
    for (std::size_t k = 0; k < truth.size(); ++k) {
      if (k > 0) {
        const Pose2 step = between(truth[k - 1], truth[k]);
        T_track_sensor =
            T_track_sensor * Pose2{step.x + random.normal(noise.step_m), step.y + random.normal(noise.step_m),
                                   step.theta + random.normal(noise.step_rad)};
      }
      keyframes.push_back(
          {.scan = k, .T_track_sensor = T_track_sensor, .path_m = 0.5 * static_cast<double>(k), .path = {}});
      segments.append(view_from(truth[k], noise, random));
    }
  }

  std::vector<Pose2> tracked() const {
    std::vector<Pose2> poses;
    for (const Keyframe& keyframe : keyframes) poses.push_back(keyframe.T_track_sensor);
    return poses;
  }

  WallAdjustment adjusted(const std::vector<Pose2>& T_map_sensor, bool orthogonal = true,
                          int rounds = kWallRounds) const {
    WallAdjustment adjustment(keyframes, segments, T_map_sensor, kReadEveryCycle, 1, orthogonal);
    adjustment.run(rounds);
    return adjustment;
  }

 private:
  static std::vector<SensedSegment> view_from(const Pose2& T, const DriveNoise& noise, Random& random) {
    std::vector<SensedSegment> view;
    for (const Segment2& wall : kCutRoom) {
      const Vec2 along = unit(wall.heading());
      const double foot_m = along.dot(T.position() - wall.start);
      const double away_m = left_normal(along).dot(T.position() - wall.start);
      const double half_m = std::sqrt(std::max(square(kSensorReach_m) - square(away_m), 0.0));
      const double from_m = std::max(foot_m - half_m, 0.0), to_m = std::min(foot_m + half_m, wall.length());
      if (to_m - from_m < 0.5) continue;
      view.push_back(sensed({wall.start + from_m * along, wall.start + to_m * along}, T,
                            random.normal(noise.offset_m), random.normal(noise.heading_rad)));
    }
    return view;
  }
};

double keyframes_rmse_m(const std::vector<Pose2>& thought, const std::vector<Pose2>& truth) {
  double sum_m2 = 0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    sum_m2 += (thought[k].position() - truth[k].position()).squaredNorm();
  return std::sqrt(sum_m2 / static_cast<double>(truth.size()));
}

/// Greatest distance of an end of a learned wall from the line of the room's wall with the same heading [m].
double worst_wall_m(const std::vector<WallEstimate>& walls) {
  double worst_m = 0;
  for (const WallEstimate& wall : walls) {
    const auto same = std::min_element(kCutRoom.begin(), kCutRoom.end(), [&](const auto& a, const auto& b) {
      return std::abs(wrap_angle(a.heading() - wall.heading_rad)) <
             std::abs(wrap_angle(b.heading() - wall.heading_rad));
    });
    const Vec2 normal = left_normal(unit(same->heading()));
    for (const Vec2& end : {wall.segment().start, wall.segment().end})
      worst_m = std::max(worst_m, std::abs(normal.dot(end - same->start)));
  }
  return worst_m;
}

std::vector<Pose2> moved_by(const Pose2& T, std::vector<Pose2> poses) {
  for (Pose2& pose : poses) pose = T * pose;
  return poses;
}

Pose2 any_pose(Random& random) {
  return {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-kPi, kPi)};
}

constexpr double kProbe = 1e-6;

/// Central difference of a residual by one of its unknowns.
template <class Residual>
auto slope(const Residual& residual_at) -> decltype(residual_at(0.0)) {
  return (residual_at(kProbe) - residual_at(-kProbe)) / (2 * kProbe);
}

Pose2 nudged(Pose2 pose, int unknown, double by) {
  (unknown == 0 ? pose.x : unknown == 1 ? pose.y : pose.theta) += by;
  return pose;
}

TEST(WallResiduals, AMotionHasTheDerivativesOfItsDifferences) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose2 from = any_pose(random), to = any_pose(random);
    const Pose2 tracked = between(from, to) * Pose2{random.normal(), random.normal(), random.normal()};
    const MotionResidual residual(from, to, tracked);
    for (int unknown = 0; unknown < 3; ++unknown) {
      const Vec3 by_from = slope(
          [&](double by) -> Vec3 { return MotionResidual(nudged(from, unknown, by), to, tracked).off; });
      const Vec3 by_to = slope(
          [&](double by) -> Vec3 { return MotionResidual(from, nudged(to, unknown, by), tracked).off; });
      EXPECT_LT((by_from - residual.by_from.col(unknown)).norm(), 1e-7);
      EXPECT_LT((by_to - residual.by_to.col(unknown)).norm(), 1e-7);
    }
  }
}

TEST(WallResiduals, ASegmentHasTheDerivativesOfItsDifferences) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    WallEstimate wall;
    wall.anchor = any_pose(random).position();
    wall.set_heading(random.uniform(-kPi, kPi));
    const Pose2 pose = any_pose(random);
    SensedSegment segment;
    segment.centroid = any_pose(random).position();
    segment.heading_rad = wrap_angle(wall.heading_rad - pose.theta + random.normal(0.3));
    const auto at = [&](int unknown, double by) {
      WallEstimate there = wall;
      if (unknown == 3) there.anchor += by * wall.normal;
      if (unknown == 4) there.set_heading(wall.heading_rad + by);
      return SegmentResidual(segment, unknown < 3 ? nudged(pose, unknown, by) : pose, there);
    };
    constexpr std::array<double, 5> kTurnBy = {0, 0, 1, 0, -1};
    for (int unknown = 0; unknown < 5; ++unknown) {
      const auto u = static_cast<std::size_t>(unknown);
      EXPECT_NEAR(slope([&](double by) { return at(unknown, by).offset_m; }), at(0, 0).offset_by[u], 1e-7);
      EXPECT_NEAR(slope([&](double by) { return at(unknown, by).turn_rad; }), kTurnBy[u], 1e-7);
    }
  }
}

TEST(WallResiduals, AreNoneWhereEverythingAgrees) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Pose2 from = any_pose(random), to = any_pose(random);
    EXPECT_LT(MotionResidual(from, to, between(from, to)).off.norm(), 1e-12);
    const Segment2 piece{any_pose(random).position(), any_pose(random).position()};
    WallEstimate wall;
    wall.set_heading(piece.heading());
    wall.anchor = piece.start + random.uniform(-3, 3) * wall.along;
    const SegmentResidual residual(sensed(piece, from, 0, 0), from, wall);
    EXPECT_NEAR(residual.offset_m, 0, 1e-12);
    EXPECT_NEAR(residual.turn_rad, 0, 1e-12);
  }
}

TEST(WallAdjustment, ExactDataStayAsTheyAre) {
  const RoomDrive drive;
  for (const bool orthogonal : {true, false}) {
    const WallAdjustment adjustment = drive.adjusted(drive.truth, orthogonal);
    for (std::size_t k = 0; k < drive.truth.size(); ++k)
      EXPECT_THAT(adjustment.T_map_sensor()[k], PoseNear(drive.truth[k], 1e-9, 1e-9)) << k;
    EXPECT_EQ(adjustment.walls().size(), kCutRoom.size());
    EXPECT_LT(worst_wall_m(adjustment.walls()), 1e-9);
  }
}

TEST(WallAdjustment, WheelsThatCountTooLittleAreScaled) {
  constexpr double kFactor = 1.03;
  RoomDrive drive;
  double counted_m = 0;
  for (std::size_t k = 0; k < drive.keyframes.size(); ++k) {
    const Vec2 counted = (drive.truth[k].position() - drive.truth[0].position()) / kFactor;
    counted_m += counted.norm();
    Pose2& T = drive.keyframes[k].T_track_sensor;
    T = {drive.truth[0].x + counted.x(), drive.truth[0].y + counted.y(), T.theta};
    drive.keyframes[k].path = {.by_factor = counted, .counted_m = counted};
  }
  ASSERT_GT(counted_m, 1);
  WallAdjustment adjustment(drive.keyframes, drive.segments, drive.truth, kReadEveryCycle, kFactor, true);
  adjustment.run(kWallRounds);
  for (std::size_t k = 0; k < drive.truth.size(); ++k)
    EXPECT_THAT(adjustment.T_map_sensor()[k], PoseNear(drive.truth[k], 1e-9, 1e-9)) << k;
}

TEST(WallAdjustment, WithoutWallsKeyframesAreAsTracked) {
  RoomDrive drive(kUsualDrive);
  drive.segments = {};
  for (std::size_t k = 0; k < drive.keyframes.size(); ++k) drive.segments.append({});
  Random random(4);
  std::vector<Pose2> begun = drive.truth;
  for (Pose2& pose : begun)
    pose = pose * Pose2{random.normal(0.05), random.normal(0.05), random.normal(2 * kDegree)};
  const WallAdjustment adjustment = drive.adjusted(begun, true, 20);
  EXPECT_TRUE(adjustment.walls().empty());
  EXPECT_TRUE(adjustment.sightings().empty());
  EXPECT_THAT(adjustment.T_map_sensor()[0].position(), PointNear(begun[0].position(), 1e-6));
  for (std::size_t k = 1; k < begun.size(); ++k) {
    EXPECT_THAT(between(adjustment.T_map_sensor()[k - 1], adjustment.T_map_sensor()[k]),
                PoseNear(relative_pose(drive.keyframes[k - 1], drive.keyframes[k], 1), 1e-6, 1e-6))
        << k;
  }
}

/// The axes turn into each other by quarter turns; without axes there is no direction to lose.
TEST(WallAdjustment, MovesAlongWithEverything) {
  const RoomDrive drive(kUsualDrive);
  for (const bool orthogonal : {true, false}) {
    const WallAdjustment there = drive.adjusted(drive.tracked(), orthogonal);
    for (const double turn_rad : {kPi / 2, -kPi / 2, kPi, 0.7}) {
      if (orthogonal && turn_rad == 0.7) continue;
      const Pose2 T_moved_map{3.3, -12.4, turn_rad};
      const WallAdjustment here = drive.adjusted(moved_by(T_moved_map, drive.tracked()), orthogonal);
      for (std::size_t k = 0; k < drive.truth.size(); ++k) {
        EXPECT_THAT(here.T_map_sensor()[k], PoseNear(T_moved_map * there.T_map_sensor()[k], 1e-8, 1e-8))
            << k << (orthogonal ? " with" : " without") << " axes, turned by " << turn_rad;
      }
      ASSERT_EQ(here.walls().size(), there.walls().size());
      for (std::size_t w = 0; w < here.walls().size(); ++w) {
        const Segment2 expected = T_moved_map * there.walls()[w].segment();
        EXPECT_THAT(here.walls()[w].segment().start, PointNear(expected.start, 1e-7));
        EXPECT_THAT(here.walls()[w].segment().end, PointNear(expected.end, 1e-7));
      }
    }
  }
}

TEST(WallAdjustment, NoisyDataEndNearerToTheTruth) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const RoomDrive drive(kUsualDrive, Random(seed));
    const WallAdjustment begun = drive.adjusted(drive.tracked(), true, 0);
    const WallAdjustment adjustment = drive.adjusted(drive.tracked());
    const double before_m = keyframes_rmse_m(begun.T_map_sensor(), drive.truth);
    const double after_m = keyframes_rmse_m(adjustment.T_map_sensor(), drive.truth);
    EXPECT_LT(after_m, before_m / 2) << "seed " << seed << ", begun with " << before_m << " m";
    EXPECT_EQ(adjustment.walls().size(), kCutRoom.size()) << seed;
    EXPECT_LT(worst_wall_m(adjustment.walls()), before_m) << seed;
  }
}

TEST(WallAdjustment, OnlyObliqueWallsTurn) {
  const RoomDrive drive(kUsualDrive);
  int oblique = 0;
  for (const WallEstimate& wall : drive.adjusted(drive.tracked()).walls()) {
    const double to_axis_rad = std::abs(wrap_quarter_turn(wall.heading_rad));
    if (wall.is_oblique()) {
      ++oblique;
      EXPECT_NEAR(wall.heading_rad, 0.75 * kPi, 0.5 * kDegree);
    } else {
      EXPECT_LT(to_axis_rad, 1e-12);
    }
  }
  EXPECT_EQ(oblique, 1);
  for (const WallEstimate& wall : drive.adjusted(drive.tracked(), false).walls())
    EXPECT_TRUE(wall.is_oblique());
}

TEST(WallAdjustment, SightingsAreCountedAndLieOnTheirWalls) {
  const RoomDrive drive;
  const WallAdjustment adjustment = drive.adjusted(drive.truth);
  const std::vector<WallEstimate> walls = adjustment.walls();
  std::vector<int> seen(walls.size(), 0);
  double path_m = 0;
  for (const WallSighting& sighting : adjustment.sightings()) {
    const WallEstimate& wall = walls[static_cast<std::size_t>(sighting.wall)];
    ++seen[static_cast<std::size_t>(sighting.wall)];
    EXPECT_NEAR(wall.offset_of(sighting.segment.start), 0, 1e-9);
    EXPECT_NEAR(wall.offset_of(sighting.segment.end), 0, 1e-9);
    EXPECT_GE(sighting.path_m, path_m) << "not in the order of the path";
    path_m = sighting.path_m;
  }
  for (std::size_t w = 0; w < walls.size(); ++w) EXPECT_EQ(walls[w].sightings, seen[w]);
}

/// A partition in the room's middle that only some keyframes see, always from the same side.
RoomDrive with_partition_seen(int times) {
  RoomDrive drive;
  ScanSegments segments;
  const Segment2 partition{{3, 3}, {5, 3}};
  for (std::size_t k = 0; k < drive.truth.size(); ++k) {
    std::vector<SensedSegment> view(drive.segments.of_scan(k).begin(), drive.segments.of_scan(k).end());
    if (drive.truth[k].y > 3.5 && times-- > 0) view.push_back(sensed(partition, drive.truth[k], 0, 0));
    segments.append(view);
  }
  drive.segments = segments;
  return drive;
}

TEST(WallAdjustment, AWallSeenTwiceTakesNoPart) {
  const RoomDrive twice = with_partition_seen(2), thrice = with_partition_seen(3);
  EXPECT_EQ(twice.adjusted(twice.truth).walls().size(), kCutRoom.size());
  EXPECT_EQ(thrice.adjusted(thrice.truth).walls().size(), kCutRoom.size() + 1);
}

/// How far keyframes are displaced by one segment of one of them that is off by this much [m].
double displaced_by_segment_off_m(double off_m) {
  constexpr std::size_t kKeyframe = 7;
  RoomDrive drive;
  ScanSegments segments;
  for (std::size_t k = 0; k < drive.truth.size(); ++k) {
    std::vector<SensedSegment> view(drive.segments.of_scan(k).begin(), drive.segments.of_scan(k).end());
    if (k == kKeyframe) {
      const Vec2 across = left_normal(unit(view[0].heading_rad));
      view[0].centroid += off_m * across;
      view[0].segment.start += off_m * across;
      view[0].segment.end += off_m * across;
    }
    segments.append(view);
  }
  drive.segments = segments;
  const WallAdjustment adjustment = drive.adjusted(drive.truth, true, 1);
  double worst_m = 0;
  for (std::size_t k = 0; k < drive.truth.size(); ++k)
    worst_m = std::max(worst_m, (adjustment.T_map_sensor()[k].position() - drive.truth[k].position()).norm());
  return worst_m;
}

TEST(WallAdjustment, ASegmentFarOffItsWallIsOutweighed) {
  const double near_m = displaced_by_segment_off_m(0.04), far_m = displaced_by_segment_off_m(0.14);
  EXPECT_GT(near_m, 1e-4) << "a segment that hardly matters shows nothing";
  EXPECT_LT(far_m, near_m);
}

/// How far the keyframes are displaced when the track slips sideways before one of them [m].
double displaced_by_slip_m(double slip_m, bool relocated) {
  constexpr std::size_t kKeyframe = 7;
  RoomDrive drive;
  const Pose2 T_slipped = drive.truth[kKeyframe] * Pose2{0, slip_m, 0} * drive.truth[kKeyframe].inverse();
  for (std::size_t k = kKeyframe; k < drive.truth.size(); ++k)
    drive.keyframes[k].T_track_sensor = T_slipped * drive.truth[k];
  drive.keyframes[kKeyframe].relocated = relocated;
  return keyframes_rmse_m(drive.adjusted(drive.truth).T_map_sensor(), drive.truth);
}

TEST(WallAdjustment, ASlipOfTheTrackIsOutweighedByTheWalls) {
  const double near_m = displaced_by_slip_m(0.03, false), far_m = displaced_by_slip_m(0.5, false);
  EXPECT_GT(near_m, 1e-5) << "a slip that hardly matters shows nothing";
  EXPECT_LT(far_m, near_m);
}

TEST(WallAdjustment, AGuessedMotionCountsLess) {
  EXPECT_LT(displaced_by_slip_m(0.03, true), displaced_by_slip_m(0.03, false) / 2);
}

}  // namespace
}  // namespace aisle
