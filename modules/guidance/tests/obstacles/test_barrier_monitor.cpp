#include "aisle/guidance/obstacles/barrier_monitor.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "free_floor.hpp"

namespace aisle {
namespace {

const std::vector<Barrier> kAcross = {{.segment = {{3, -1}, {3, 1}}}};

bool must_stop(double x_m, const Command& command) {
  return barrier_ahead(kAcross, cart(), {x_m, 0, 0}, command) != nullptr;
}

TEST(BarrierMonitor, StopsAVehicleBeforeItIsTooLateToBrake) {
  const double front_m = cart().footprint.front_m;
  EXPECT_FALSE(must_stop(0, {.speed_mps = 0.5}));
  EXPECT_TRUE(must_stop(3 - front_m - 0.1, {.speed_mps = 0.5}));
  EXPECT_FALSE(must_stop(3 - front_m - 0.1, {.speed_mps = 0.1})) << "slow enough";
  EXPECT_FALSE(must_stop(3 - front_m - 0.1, {.speed_mps = -0.5})) << "away from it";
}

TEST(BarrierMonitor, LooksWhereTheVehicleGoes) {
  const Pose2 T_map_vehicle{1.7, -0.9, -0.2};
  EXPECT_EQ(barrier_ahead(kAcross, cart(), T_map_vehicle, {.speed_mps = 0.5, .steering_rad = -0.7}), nullptr);
}

TEST(BarrierMonitor, IgnoresAStandingVehicle) {
  EXPECT_FALSE(must_stop(2.9, {}));
}

}  // namespace
}  // namespace aisle
