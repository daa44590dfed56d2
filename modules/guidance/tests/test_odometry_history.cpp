#include "aisle/guidance/odometry_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace aisle {
namespace {

constexpr double kHistoryCycle_s = 0.1;

/// Drives straight on, by 2 cm more in every cycle.
OdometryHistory ever_faster(const VehicleDescription& vehicle, int cycles) {
  OdometryHistory history(vehicle);
  for (int i = 1; i <= cycles; ++i)
    history.move({.stamp_s = kHistoryCycle_s * i, .odometry = FrontSteeredMotion{.distance_m = 0.02 * i}});
  return history;
}

TEST(OdometryHistory, KnowsWhereTheVehicleWasBetweenTwoCycles) {
  const OdometryHistory history = ever_faster({}, 4);
  EXPECT_NEAR(history.T_odom_vehicle().x, 0.2, 1e-9);
  EXPECT_NEAR(history.T_odom_at(0.4).x, 0.2, 1e-9);
  EXPECT_NEAR(history.T_odom_at(0.3).x, 0.12, 1e-9);
  EXPECT_NEAR(history.T_odom_at(0.325).x, 0.14, 1e-9);
  EXPECT_NEAR(history.T_odom_at(-1).x, 0.02, 1e-9) << "the first cycle's end is the oldest that it knows";
}

TEST(OdometryHistory, CountsCyclesSinceTheNearestOne) {
  const OdometryHistory history = ever_faster({}, 8);
  EXPECT_EQ(history.cycles_since(0.83), 0);
  EXPECT_EQ(history.cycles_since(0.76), 0);
  EXPECT_EQ(history.cycles_since(0.74), 1);
  EXPECT_EQ(history.cycles_since(0.41), 4);
}

TEST(OdometryHistory, RemembersTheLastCyclesHoweverManyThereWere) {
  const OdometryHistory history = ever_faster({}, 1000);
  EXPECT_NEAR(history.T_odom_at(98.0).x, history.T_odom_vehicle().x - 0.02 * (20 * 981 + 190), 1e-6);
  EXPECT_EQ(history.cycles_since(98.0), 20);
  EXPECT_EQ(history.cycles_since(10), 63) << "as far back as it remembers";
}

/// As if the wheels had reported rightly since then.
TEST(OdometryHistory, CorrectsWhatItRemembersSinceATime) {
  const OdometryCorrection error{.distance_factor = 1.5, .steering_bias_rad = 0.1};
  OdometryHistory corrected({}), right({});
  for (int i = 1; i <= 100; ++i) {
    const FrontSteeredMotion reported{0.02, 0.3 * std::sin(i / 10.0)};
    const bool is_wrong = i > 70;
    if (i == 91) corrected.correct(error, kHistoryCycle_s * 70);
    corrected.move({.stamp_s = kHistoryCycle_s * i, .odometry = reported});
    right.move({.stamp_s = kHistoryCycle_s * i, .odometry = is_wrong ? error.corrected(reported) : reported});
  }
  for (const double stamp_s : {6.0, 7.0, 7.55, 9.0, 10.0}) {
    const Pose2 off = between(right.T_odom_at(stamp_s), corrected.T_odom_at(stamp_s));
    EXPECT_NEAR(off.position().norm(), 0, 1e-9) << stamp_s;
    EXPECT_NEAR(off.theta, 0, 1e-9) << stamp_s;
  }
}

}  // namespace
}  // namespace aisle
