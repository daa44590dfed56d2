#include "aisle/guidance/paths/path_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "free_floor.hpp"

namespace aisle {
namespace {

constexpr double kDriveCycle_s = 0.1;

Path path_of(const std::vector<Arc>& arcs, Pose2 T_map_start) {
  std::vector<PathPiece> pieces;
  for (const Arc& arc : arcs) {
    pieces.push_back({T_map_start, arc});
    T_map_start = pieces.back().end();
  }
  return Path(std::move(pieces));
}

/// A cart that executes commands without delay.
class PathDriving : public testing::TestWithParam<bool> {
 protected:
  PathDriver::Step cycle() {
    const PathDriver::Step step = driver_.drive(hall_, footprint_clearance_, T_map_vehicle_, steering_rad_);
    steering_rad_ = step.command.steering_rad;
    const double path_m = kDriveCycle_s * step.command.speed_mps;
    T_map_vehicle_ =
        T_map_vehicle_ * (vehicle_.is_differential
                              ? end_pose({path_m, kDriveCycle_s * step.command.turn_rate_rad_s})
                              : drive(vehicle_.front_steered, FrontSteeredMotion{path_m, steering_rad_}));
    return step;
  }

  /// Runs until the vehicle does anything but drive, for at most a minute.
  PathDriver::State drive_on() {
    PathDriver::State state = PathDriver::State::kDriving;
    for (int i = 0;
         i < 600 && (state == PathDriver::State::kDriving || state == PathDriver::State::kTurningWheels); ++i)
      state = cycle().state;
    return state;
  }

  KnownFloor hall_ = free_floor({{Vec2(0, 0), Vec2(12, 8)}});
  const VehicleDescription vehicle_ = cart_of(GetParam());
  FootprintClearance footprint_clearance_{vehicle_.footprint, 0.05};
  PathDriver driver_{vehicle_, {}, {}};
  Pose2 T_map_vehicle_{2, 4, 0};
  double steering_rad_ = 0;
};

INSTANTIATE_TEST_SUITE_P(, PathDriving, testing::Bool(), name_of_drive);

class FrontSteeredPathDriving : public PathDriving {};
INSTANTIATE_TEST_SUITE_P(, FrontSteeredPathDriving, testing::Values(false), name_of_drive);

class DifferentialPathDriving : public PathDriving {};
INSTANTIATE_TEST_SUITE_P(, DifferentialPathDriving, testing::Values(true), name_of_drive);

TEST_P(PathDriving, StandsWithoutAPath) {
  steering_rad_ = 0.2;
  const PathDriver::Step step = cycle();
  EXPECT_EQ(step.state, PathDriver::State::kNoPath);
  EXPECT_EQ(step.command, (Command{.steering_rad = 0.2}));
}

TEST_P(PathDriving, ArrivesAtThePathsEndThereAndBack) {
  const Path taken = path_of({{3, 0}, {2, 1}, {-2, 0.5}}, T_map_vehicle_);
  driver_.take(taken);
  EXPECT_EQ(drive_on(), PathDriver::State::kArrived);
  EXPECT_LT((T_map_vehicle_.position() - taken.end().position()).norm(), 0.08);
}

TEST_P(PathDriving, DrivesAContinuedPathWithoutAStop) {
  driver_.take(path_of({{2, 0}}, T_map_vehicle_));
  while (driver_.left_m() > 1) ASSERT_EQ(cycle().state, PathDriver::State::kDriving);
  driver_.take(path_of({{3, 0}}, driver_.path().end()));
  while (driver_.left_m() > 1) ASSERT_GT(cycle().command.speed_mps, 0.1);
  EXPECT_GT(T_map_vehicle_.x, 5.5);
}

TEST_P(PathDriving, IsBlockedBeforeUnknownFloor) {
  driver_.take(path_of({{12, 0}}, T_map_vehicle_));
  EXPECT_NEAR(driver_.free_m(hall_, T_map_vehicle_), 9, 0.2);
  EXPECT_EQ(drive_on(), PathDriver::State::kBlocked);
  EXPECT_LT(T_map_vehicle_.x + cart().footprint.front_m, 12);
  EXPECT_GT(T_map_vehicle_.x, 10);
}

TEST_P(PathDriving, DrivesThePartAlongItsTrailOverUnknownFloor) {
  driver_.take(path_of({{10.5, 0}}, T_map_vehicle_), 3);
  EXPECT_NEAR(driver_.free_m(hall_, T_map_vehicle_), driver_.left_m(), 1e-9);
  EXPECT_EQ(drive_on(), PathDriver::State::kArrived);
  EXPECT_NEAR(T_map_vehicle_.x, 12.5, 0.08);
}

TEST_P(PathDriving, IsBlockedByPresentLaserReturns) {
  std::vector<float> ranges_m(181, 20);
  ranges_m[90] = 0.1F;
  driver_.take(path_of({{4, 0}}, T_map_vehicle_));
  driver_.see(kGeometry, ranges_m);
  const PathDriver::Step step = cycle();
  EXPECT_EQ(step.state, PathDriver::State::kBlocked);
  EXPECT_EQ(step.direction, LegDirection::kForward);
  EXPECT_EQ(step.command.speed_mps, 0);
}

TEST_P(FrontSteeredPathDriving, TurnsItsWheelsBeforeACurvedLeg) {
  driver_.take(path_of({{3, 2}}, T_map_vehicle_));
  const PathDriver::Step step = cycle();
  EXPECT_EQ(step.state, PathDriver::State::kTurningWheels);
  EXPECT_EQ(step.command.speed_mps, 0);
  EXPECT_GT(step.command.steering_rad, 10 * kDegree);
  EXPECT_EQ(cycle().state, PathDriver::State::kDriving);
}

TEST_P(FrontSteeredPathDriving, IsNotHeldUpByABendSharperThanItsSteeringRange) {
  const double steering_max_rad = cart().limits.steering_max_rad;
  const double bend_per_m = 1.3 * std::tan(steering_max_rad) / cart().front_steered.wheelbase_m;
  driver_.take(path_of({{-0.5, -0.5 * bend_per_m}}, T_map_vehicle_));
  steering_rad_ = steering_max_rad;
  EXPECT_EQ(cycle().state, PathDriver::State::kDriving);
}

TEST_P(PathDriving, StopsAtTheEndOfAShortenedPath) {
  driver_.take(path_of({{6, 0}}, T_map_vehicle_));
  driver_.shorten(2);
  EXPECT_DOUBLE_EQ(driver_.left_m(), 2);
  EXPECT_EQ(drive_on(), PathDriver::State::kArrived);
  EXPECT_NEAR(T_map_vehicle_.x, 4, 0.08);
}

TEST_P(DifferentialPathDriving, FinishesATurnOnTheSpotWhenItsPathIsShortenedAndContinued) {
  driver_.take(path_of({{1, 0}, {0, kPi / 2}, {1, 0}}, T_map_vehicle_));
  while (T_map_vehicle_.theta < 20 * kDegree) ASSERT_EQ(cycle().state, PathDriver::State::kDriving);
  driver_.shorten(0.6);
  EXPECT_NEAR(driver_.path().end().theta, kPi / 2, 1e-9);
  driver_.take(path_of({{2, 0}}, driver_.path().end()));
  EXPECT_EQ(drive_on(), PathDriver::State::kArrived);
  EXPECT_NEAR(T_map_vehicle_.x, 3, 0.05);
  EXPECT_NEAR(T_map_vehicle_.y, 6, 0.05);
}

TEST_P(DifferentialPathDriving, IsBlockedWhereItsCornersWouldTouchAndSaysWhichWay) {
  T_map_vehicle_ = {2, 0.4, 0};
  driver_.take(path_of({{0, -kPi / 2}}, T_map_vehicle_));
  EXPECT_EQ(drive_on(), PathDriver::State::kBlocked);
  EXPECT_EQ(cycle().direction, LegDirection::kRight);
  EXPECT_GT(T_map_vehicle_.theta, -20 * kDegree);
}

}  // namespace
}  // namespace aisle
