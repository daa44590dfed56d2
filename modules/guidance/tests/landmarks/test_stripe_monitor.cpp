#include "aisle/guidance/landmarks/stripe_monitor.hpp"

#include <gtest/gtest.h>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// Light on both walls of a corridor along x, 2.4 m wide, seen from a pose in it.
std::vector<Vec2> along_corridor(const Pose2& T_world_vehicle) {
  std::vector<Vec2> lit;
  for (int i = 0; i < 75; ++i) {
    for (const double side_m : {-1.2, 1.2})
      lit.push_back(T_world_vehicle.inverse() * Vec2(T_world_vehicle.x + 1.6 + 0.06 * i, side_m));
  }
  return lit;
}

/// Light on a wall 2 m ahead.
std::vector<Vec2> before_wall() {
  std::vector<Vec2> lit;
  for (int i = 0; i < 150; ++i) lit.emplace_back(2.0, -1.2 + 0.016 * i);
  return lit;
}

TEST(StripeMonitor, DrivingOnAlongACorridorAndTurningALittleIsNoOtherPlace) {
  StripeMonitor monitor;
  Pose2 T_world_vehicle;
  for (int i = 0; i < 100; ++i) {
    const Pose2 step{0.05, 0, (i % 20 < 10 ? 1 : -1) * 0.5 * kDegree};
    T_world_vehicle = T_world_vehicle * step;
    monitor.move(step);
    EXPECT_FALSE(monitor.look(along_corridor(T_world_vehicle))) << i;
  }
}

TEST(StripeMonitor, AWallThatStandsAheadFromOneImageToTheNextIsAnotherPlace) {
  StripeMonitor monitor;
  EXPECT_FALSE(monitor.look(along_corridor({})));
  EXPECT_FALSE(monitor.look(before_wall()));
  EXPECT_TRUE(monitor.look(before_wall()));
  EXPECT_FALSE(monitor.look(before_wall()));
}

TEST(StripeMonitor, OneImageAloneIsNoOtherPlace) {
  StripeMonitor monitor;
  monitor.look(along_corridor({}));
  EXPECT_FALSE(monitor.look(before_wall()));
  EXPECT_FALSE(monitor.look(along_corridor({})));
  EXPECT_FALSE(monitor.look(before_wall()));
}

TEST(StripeMonitor, AnImageThatShowsWhatIsKnownToBeHereIsNoOtherPlace) {
  StripeMonitor monitor;
  monitor.look(along_corridor({}));
  EXPECT_FALSE(monitor.look(before_wall(), true));
  EXPECT_FALSE(monitor.look(before_wall(), true));
}

TEST(StripeMonitor, LittleLightTellsNothing) {
  StripeMonitor monitor;
  monitor.look(along_corridor({}));
  const std::vector<Vec2> some(20, Vec2(2, 0));
  EXPECT_FALSE(monitor.look(some));
  EXPECT_FALSE(monitor.look(some));
}

}  // namespace
}  // namespace aisle
