#include <gmock/gmock.h>

#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/learning/sections/section_learning.hpp"

namespace aisle {
namespace {

using Kind = Section::Kind;

VehicleDescription mini_vehicle() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  return vehicle;
}

/// Drives a small vehicle and records what its wheels count.
class Drive {
 public:
  /// A wall along the drive's first direction, to its left (positive) or right.
  void set_wall(double lateral_m) { wall_m_ = lateral_m; }

  /// A wall across the drive's first direction, which is on the right once the vehicle has turned left; 0:
  /// none.
  void set_wall_across(double along_m) { across_m_ = along_m; }

  /// Turns without the wheels counting it.
  void slip(double turn_rad) { T_ = T_ * Pose2{0, 0, turn_rad}; }

  /// From here on images show only a misaligned edge; 0: no more.
  void set_misaligned(double yaw_error_rad) { yaw_error_rad_ = yaw_error_rad; }

  /// From here on the floor's texture looks like edges that turn as the drive goes on; 0: no more.
  void set_grain(double turn_rad_per_m) {
    grain_rad_per_m_ = turn_rad_per_m;
    grain_from_ = T_.position();
  }

  void go(double length_m, double turn_rad = 0) {
    const double step_m = vehicle_.differential.step_length_m();
    const double turn_m = turn_rad * vehicle_.differential.wheel_separation_m / 2;
    const int cycles = std::max(1, static_cast<int>((std::abs(length_m) + std::abs(turn_m)) / 0.02));
    for (int i = 0; i < cycles; ++i) {
      left_m_ += (length_m - turn_m) / cycles;
      right_m_ += (length_m + turn_m) / cycles;
      const int left = static_cast<int>(std::lround(left_m_ / step_m)) - left_;
      const int right = static_cast<int>(std::lround(right_m_ / step_m)) - right_;
      left_ += left;
      right_ += right;
      T_ = T_ * end_pose(Arc{length_m / cycles, turn_rad / cycles});
      cycles_.push_back({.stamp_s = 0.1 * static_cast<double>(cycles_.size()),
                         .odometry = WheelSteps{left, right},
                         .floor_edges = edges()});
    }
  }

  DrivenList recorded() const { return record_drive(cycles_, vehicle_, {}); }

 private:
  std::vector<SensedSegment> edges() const {
    constexpr double kSeenFrom_m = 2.4;
    std::vector<SensedSegment> seen;
    if (wall_m_ != 0) {
      const Vec2 near{T_.x + 0.5, wall_m_}, far = near + 2 * unit(yaw_error_rad_);
      seen.push_back(wall_m_ > 0 ? edge(far, near) : edge(near, far));
    }
    if (grain_rad_per_m_ != 0) {
      const double turned_rad = grain_rad_per_m_ * (T_.position() - grain_from_).norm();
      for (const double lateral_m : {-0.2, 0.2}) {
        const Vec2 near = T_ * Vec2(3, lateral_m);
        SensedSegment grain = edge(near, near + unit(T_.theta + turned_rad));
        grain.length_m = 1;
        grain.sigma_heading_rad = 5 * kDegree;
        seen.push_back(grain);
      }
    }
    if (across_m_ != 0 && across_m_ - T_.x < kSeenFrom_m) {
      const double from_m = T_.y + (T_.theta > kPi / 4 ? 0.5 : -1);
      seen.push_back(edge({across_m_, from_m}, {across_m_, from_m + 2}));
    }
    return seen;
  }

  SensedSegment edge(const Vec2& p_world_start, const Vec2& p_world_end) const {
    SensedSegment edge;
    edge.segment = {T_.inverse() * p_world_start, T_.inverse() * p_world_end};
    edge.centroid = (edge.segment.start + edge.segment.end) / 2;
    edge.heading_rad = heading_of(edge.segment.end - edge.segment.start);
    edge.length_m = 2;
    edge.sigma_offset_m = 0.02;
    edge.sigma_heading_rad = 1 * kDegree;
    return edge;
  }

  VehicleDescription vehicle_ = mini_vehicle();
  Pose2 T_;
  double wall_m_ = 0, across_m_ = 0, yaw_error_rad_ = 0, grain_rad_per_m_ = 0;
  Vec2 grain_from_{0, 0};
  double left_m_ = 0, right_m_ = 0;
  int left_ = 0, right_ = 0;
  std::vector<SectionCycle> cycles_;
};

TEST(SectionRecording, TurnsOnTheSpotAreTakenAsTheyAre) {
  Drive drive;
  drive.go(3);
  drive.go(0, -kPi / 2);
  drive.go(2);
  const SectionList list = drive.recorded().sections;
  ASSERT_EQ(list.size(), 3U);
  EXPECT_NEAR(list[0].length_m, 3, 0.05);
  EXPECT_NEAR(list[1].turn_rad, -kPi / 2, 1e-12);
  EXPECT_NEAR(list[2].length_m, 2, 0.05);
}

TEST(SectionRecording, ARightArcBecomesATurnAtTheCornerOfItsTangents) {
  Drive drive;
  drive.go(3);
  drive.go(0.5 * kPi / 2, -kPi / 2);  // radius 0.5 m
  drive.go(2);
  const SectionList list = drive.recorded().sections;
  ASSERT_EQ(list.size(), 3U);
  EXPECT_NEAR(list[0].length_m, 3.5, 0.05);
  EXPECT_NEAR(list[1].turn_rad, -kPi / 2, 1e-12);
  EXPECT_NEAR(list[2].length_m, 2.5, 0.05);
}

TEST(SectionRecording, ALeftArcBecomesTwoTurnsWithItsChordAndThusACorner) {
  Drive drive;
  drive.go(3);
  drive.go(0.6 * kPi / 2, kPi / 2);
  drive.go(2);
  const DrivenList driven = drive.recorded();
  const SectionList list = decide_sections(driven.sections, {}, {});
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].kind, Kind::kCurve);
  EXPECT_NEAR(list[1].p_start_end.x(), 0.6, 0.08);
  EXPECT_NEAR(list[1].p_start_end.y(), 0.6, 0.08);
}

TEST(SectionRecording, TheMeanDistanceOfABaseLineIsKept) {
  Drive drive;
  drive.set_wall(-0.45);
  drive.go(4);
  const SectionList list = drive.recorded().sections;
  ASSERT_EQ(list.size(), 1U);
  ASSERT_TRUE(list[0].right_m);
  EXPECT_NEAR(*list[0].right_m, 0.45, 0.02);
  EXPECT_FALSE(list[0].left_m);
}

TEST(SectionRecording, AMisalignedEdgeDoesNotLeadThePathAstray) {
  Drive drive;
  drive.set_wall(-0.45);
  drive.go(5);
  drive.set_misaligned(5 * kDegree);
  drive.go(0.3);
  drive.set_misaligned(0);
  drive.go(5);
  for (const Pose2& T : drive.recorded().T_route_vehicle) {
    EXPECT_LT(std::abs(T.y), 0.01);
    EXPECT_LT(std::abs(T.theta), 1 * kDegree);
  }
}

TEST(SectionRecording, TheFloorsGrainDoesNotTurnThePath) {
  Drive drive;
  drive.set_wall(-0.45);
  drive.go(2);
  drive.set_wall(0);
  drive.set_grain(10 * kDegree);
  drive.go(6);
  drive.set_grain(0);
  drive.set_wall(-0.45);
  drive.go(4);
  const DrivenList driven = drive.recorded();
  ASSERT_EQ(driven.sections.size(), 1U);
  EXPECT_NEAR(driven.T_route_vehicle.back().y, 0, 0.1);
}

TEST(SectionRecording, TheWallAcrossOneSegmentIsTheOneBesideTheNext) {
  constexpr double kSlip_rad = 4 * kDegree, kUnseen_m = 2.5;
  Drive drive;
  drive.set_wall_across(4);
  drive.go(3);
  drive.set_wall_across(0);
  drive.slip(-kSlip_rad);
  drive.go(0, kPi / 2);
  drive.go(kUnseen_m);
  drive.slip(kSlip_rad);
  drive.set_wall_across(4);
  drive.go(4);
  const double x_m = 3 + kUnseen_m * std::sin(kSlip_rad);
  EXPECT_NEAR(drive.recorded().T_route_vehicle.back().x, x_m, 0.08);
}

TEST(SectionRecording, APathBentByOdometryBeginsWhereTheVehicleStood) {
  Drive drive;
  drive.go(20, -10 * kDegree);
  const DrivenList driven = drive.recorded();
  ASSERT_EQ(driven.sections.size(), 1U);
  EXPECT_NEAR(driven.T_route_start.theta, 0, 1e-9);
  EXPECT_NEAR(driven.T_route_start.y, driven.T_route_vehicle.front().y, 0.02);
}

TEST(SectionRecording, AStandingVehicleRecordsNothing) {
  Drive drive;
  drive.go(0);
  EXPECT_TRUE(drive.recorded().sections.empty());
  EXPECT_TRUE(record_drive({}, mini_vehicle(), {}).sections.empty());
}

TEST(SectionRecording, BackwardsStaysBackwards) {
  Drive drive;
  drive.go(2);
  drive.go(-0.8);
  const SectionList list = drive.recorded().sections;
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1].kind, Kind::kBack);
  EXPECT_NEAR(list[1].length_m, 0.8, 0.05);
}

TEST(SectionRecording, EndsASectionWhereTheBaseLineStepsToTheSide) {
  Drive drive;
  drive.set_wall(-0.5);
  drive.go(9);
  drive.set_wall(-0.8);
  drive.go(7);
  const SectionList list = drive.recorded().sections;
  ASSERT_EQ(list.size(), 2U);
  EXPECT_NEAR(list[0].length_m + list[1].length_m, 16, 0.1);
  EXPECT_NEAR(list[0].length_m, 10, 1);
  EXPECT_NEAR(list[0].right_m.value(), 0.5, 0.02);
  EXPECT_NEAR(list[1].right_m.value(), 0.8, 0.02);
}

TEST(SectionRecording, ReportsWhereNoBaseLineWasSeen) {
  Drive drive;
  for (const auto& [length_m, lateral_m] : {std::pair{4, -0.5}, {6, 0}, {5, -0.5}}) {
    drive.set_wall(lateral_m);
    drive.go(length_m);
  }
  const UnseenPathSegment unseen = drive.recorded().unseen;
  EXPECT_NEAR(unseen.from_m, 4, 0.1);
  EXPECT_NEAR(unseen.length_m, 6, 0.1);
}

TEST(SectionRecording, GoesOnPastARecess) {
  Drive drive;
  for (const double lateral_m : {-0.5, -0.8, -0.5}) {
    drive.set_wall(lateral_m);
    drive.go(lateral_m < -0.6 ? 1.5 : 7);
  }
  const SectionList list = drive.recorded().sections;
  ASSERT_EQ(list.size(), 1U);
  EXPECT_NEAR(list[0].right_m.value(), 0.5, 0.02);
}

}  // namespace
}  // namespace aisle
