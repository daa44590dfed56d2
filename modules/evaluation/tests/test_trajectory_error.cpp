#include "aisle/evaluation/trajectory_error.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// Along a circle of 2 m radius at 1 m/s, 10 poses a second.
Trajectory circle(int poses) {
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i) {
    const double stamp_s = 0.1 * i, angle = stamp_s / 2;
    trajectory.stamps_s.push_back(1000 + stamp_s);
    trajectory.T_map_vehicle.push_back({2 * std::sin(angle), 2 - 2 * std::cos(angle), wrap_angle(angle)});
  }
  return trajectory;
}

TEST(TrajectoryError, TheSamePathInAnotherFrameIsNotOff) {
  const Trajectory truth = circle(200);
  Trajectory moved = truth;
  const Pose2 T_map_truth{30, -4, 2.1};
  for (Pose2& pose : moved.T_map_vehicle) {
    pose = T_map_truth * pose;
    pose.theta = wrap_angle(pose.theta + 0.7);  // the body that was measured looks elsewhere
  }
  const auto error = trajectory_error(moved, truth, 1);
  ASSERT_TRUE(error.ok()) << to_string(error.problems());
  EXPECT_EQ(error->compared, 200U);
  EXPECT_NEAR(error->position_m.max, 0, 1e-9);
  EXPECT_NEAR(error->heading_rad.max, 0, 1e-9);
  EXPECT_NEAR(error->relative_heading_rad.max, 0, 1e-9);
  EXPECT_NEAR(error->T_truth_map.theta, wrap_angle(-2.1), 1e-9);
  EXPECT_NEAR(error->heading_offset_rad, -0.7, 1e-9);
}

TEST(TrajectoryError, AKnownErrorIsFound) {
  const Trajectory truth = circle(200);
  Trajectory off = truth;
  for (std::size_t i = 0; i < off.T_map_vehicle.size(); ++i)
    off.T_map_vehicle[i].x += i % 2 == 0 ? 0.03 : -0.03;  // the alignment cannot take it out
  const auto error = trajectory_error(off, truth, 1);
  EXPECT_NEAR(error->position_m.mean, 0.03, 1e-4);
  EXPECT_NEAR(error->position_m.rms, 0.03, 1e-4);
  EXPECT_NEAR(error->relative_position_m.max, 0.06, 0.01);
  EXPECT_LT(error->relative_heading_rad.max, 1e-9);
}

TEST(TrajectoryError, TheTruthIsInterpolatedButNotOverGaps) {
  Trajectory truth = circle(200), late = circle(190);
  for (double& stamp_s : late.stamps_s) stamp_s += 0.05;
  for (std::size_t i = 0; i < late.T_map_vehicle.size(); ++i) {
    const double angle = (0.1 * static_cast<double>(i) + 0.05) / 2;
    late.T_map_vehicle[i] = {2 * std::sin(angle), 2 - 2 * std::cos(angle), wrap_angle(angle)};
  }
  truth.stamps_s.erase(truth.stamps_s.begin() + 100, truth.stamps_s.begin() + 105);
  truth.T_map_vehicle.erase(truth.T_map_vehicle.begin() + 100, truth.T_map_vehicle.begin() + 105);
  const auto error = trajectory_error(late, truth, 1);
  EXPECT_EQ(error->without_truth, 6U);
  EXPECT_LT(error->position_m.max, 0.001);
}

TEST(TrajectoryError, WithoutCommonTimesNothingIsCompared) {
  Trajectory elsewhere = circle(50);
  for (double& stamp_s : elsewhere.stamps_s) stamp_s += 1e6;
  const auto error = trajectory_error(elsewhere, circle(50), 1);
  ASSERT_FALSE(error.ok());
  EXPECT_THAT(to_string(error.problems()), HasSubstr("0 of 50 poses have a true pose within 0.25 s"));
  Trajectory back = circle(50);
  std::swap(back.stamps_s[3], back.stamps_s[9]);
  EXPECT_THAT(to_string(trajectory_error(circle(50), back, 1).problems()), HasSubstr("stamps go back"));
}

}  // namespace
}  // namespace aisle
