#include "aisle/guidance/rooms/frame_backing.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "free_floor.hpp"

namespace aisle {
namespace {

constexpr double kBackingCycle_s = 0.1;
const Vec2 kSize_m(1.7, 1.2);
const Pose2 kFrame{5, 2, 0};
/// Parking pose: the footprint's centre on the frame's, heading out of it.
const Pose2 kParked = kFrame * Pose2{0.35, 0, kPi};

/// A vehicle that stands before a frame on known floor, with perfect odometry.
struct BackedVehicle {
  explicit BackedVehicle(const KnownFloor& known) : backing({}, cart(), kSize_m) {
    backing.begin(known.grid(), {});
  }

  Decision step(const Pose2& T_odom_frame = kFrame) {
    stamp_s += kBackingCycle_s;
    const Decision decision = backing.step(stamp_s, T_odom_vehicle, T_odom_frame, steering_rad);
    steering_rad = decision.command.steering_rad;
    T_odom_vehicle = T_odom_vehicle *
                     drive(cart().front_steered,
                           FrontSteeredMotion{kBackingCycle_s * decision.command.speed_mps, steering_rad});
    return decision;
  }
  Decision run_until(const std::string& state, const Pose2& T_odom_frame = kFrame) {
    constexpr int kCycles = 3000;
    Decision decision;
    for (int i = 0; i < kCycles && decision.state != state && decision.status == NavigatorStatus::kGoing; ++i)
      decision = step(T_odom_frame);
    return decision;
  }

  FrameBacking backing;
  Pose2 T_odom_vehicle{3, 2, 0};
  double steering_rad = 0;
  double stamp_s = 0;
};

void expect_parked(const BackedVehicle& vehicle, const Pose2& T_odom_due) {
  const Pose2 off = between(T_odom_due, vehicle.T_odom_vehicle);
  EXPECT_LT(off.position().norm(), 0.015);
  EXPECT_LT(std::abs(off.theta), 0.5 * kDegree);
}

TEST(FrameBacking, TurnsAboutAndParksBackwards) {
  BackedVehicle vehicle(free_floor({{Vec2(0, 0), Vec2(7, 4)}}));
  EXPECT_EQ(vehicle.run_until("parked").status, NavigatorStatus::kDone);
  expect_parked(vehicle, kParked);
  EXPECT_EQ(vehicle.backing.tries(), 1);
}

TEST(FrameBacking, DrivesOutAndInAgainIfMisaligned) {
  BackedVehicle vehicle(free_floor({{Vec2(0, 0), Vec2(7, 4)}}));
  vehicle.run_until("looking");
  const Pose2 seen{0.01, 0.04, 1.5 * kDegree};
  EXPECT_EQ(vehicle.run_until("driving out", kFrame * seen).state, "driving out");
  EXPECT_EQ(vehicle.run_until("parked", kFrame * seen).status, NavigatorStatus::kDone);
  expect_parked(vehicle, kFrame * seen * Pose2{0.35, 0, kPi});
  EXPECT_EQ(vehicle.backing.tries(), 2);
}

/// Where the middle of the rear is while the vehicle looks at the frame's near side.
double rear_while_looking_m(const KnownFloor& known) {
  BackedVehicle vehicle(known);
  EXPECT_EQ(vehicle.run_until("looking").state, "looking");
  return (vehicle.T_odom_vehicle * Vec2(-cart().footprint.rear_m, 0)).x();
}

TEST(FrameBacking, LooksFromTheFarLineIfTheFloorBeyondItIsFree) {
  const double line_m = kFrame.x + kSize_m.x() / 2;
  EXPECT_NEAR(rear_while_looking_m(free_floor({{Vec2(0, 0), Vec2(7, 4)}})), line_m + 0.03, 0.01);
  EXPECT_NEAR(rear_while_looking_m(free_floor({{Vec2(0, 0), Vec2(line_m, 4)}})), line_m - 0.02, 0.01);
}

TEST(FrameBacking, FailsWhereItCannotTurn) {
  BackedVehicle vehicle(free_floor({{Vec2(0, 1.5), Vec2(7, 2.5)}}));
  const Decision decision = vehicle.run_until("parked");
  EXPECT_EQ(decision.status, NavigatorStatus::kFailed);
  EXPECT_EQ(decision.state, "no room");
}

TEST(FrameBacking, AsksForTheFloorAgainIfAnObstacleStaysInItsPath) {
  BackedVehicle vehicle(free_floor({{Vec2(0, 0), Vec2(7, 4)}}));
  vehicle.run_until("turning about");
  std::vector<SeenEdge> around;
  for (double y = -0.5; y <= 0.5; y += 0.05) {
    around.push_back({Vec2(1, y), 1});
    around.push_back({Vec2(-0.3, y), 1});
  }
  vehicle.backing.see(around, vehicle.T_odom_vehicle);
  const Pose2 T_odom_begin = vehicle.T_odom_vehicle;
  for (int i = 0; i < 200 && !vehicle.backing.wants_floor(); ++i) vehicle.step();
  EXPECT_TRUE(vehicle.backing.wants_floor());
  EXPECT_LT(between(T_odom_begin, vehicle.T_odom_vehicle).position().norm(), 0.1);
}

}  // namespace
}  // namespace aisle
