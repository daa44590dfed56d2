#include "aisle/control/speed.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/random.hpp"
#include "closed_loop.hpp"

namespace aisle {
namespace {

constexpr SpeedParams kFast{.speed_mps = 0.9};

double speed(const Path& path, double along_m, double certainty = 1) {
  return speed_along(path, along_m, certainty, cart(), kFast);
}

TEST(SpeedAlong, BrakesForTheEndByHand) {
  const Path path = path_of({{10, 0}});
  EXPECT_DOUBLE_EQ(speed(path, 1), 0.9);
  // 0.1 s at 0.5707 m/s, then from there to standstill with 0.3 m/s^2: 0.0571 m + 0.5429 m
  EXPECT_NEAR(speed(path, 9.4), 0.570749, 1e-6);
  EXPECT_DOUBLE_EQ(speed(path, 9.999), kFast.speed_min_mps);
  EXPECT_EQ(speed(path, 10), 0);
}

TEST(SpeedAlong, TakesBendsGentlyAndBrakesBeforeThem) {
  const Path path = path_of({{5, 0}, {kPi / 2, kPi / 2}, {5, 0}});
  EXPECT_NEAR(speed(path, 5.5), std::sqrt(0.4), 1e-9);
  EXPECT_NEAR(speed(path, 4.8), std::sqrt(0.03 * 0.03 + 0.4 + 2 * 0.3 * 0.2) - 0.03, 1e-9);
  EXPECT_DOUBLE_EQ(speed(path, 1), 0.9);
}

TEST(SpeedAlong, StopsWhereThePathTurnsBackAndGoesOnFromThere) {
  const Path path = path_of({{5, 0}, {-5, 0}});
  EXPECT_DOUBLE_EQ(speed(path, 4.999), kFast.speed_min_mps);
  EXPECT_DOUBLE_EQ(speed(path, 5), cart().limits.reverse_speed_max_mps);
}

TEST(SpeedAlong, IsLessWhenThePoseIsUncertain) {
  const Path path = path_of({{10, 0}});
  EXPECT_DOUBLE_EQ(speed(path, 1, 0.5), 0.45);
  EXPECT_DOUBLE_EQ(speed(path, 1, 0), kFast.speed_min_mps);
}

RC_GTEST_PROP(SpeedAlong, NeverExceedsALimitAndCanAlwaysBrake, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<Arc> arcs;
  for (int i = 0; i < 5; ++i) {
    arcs.push_back({random.uniform(-3, 3), random.uniform() < 0.5 ? 0 : random.uniform(-2, 2)});
  }
  const Path path = path_of(arcs);
  const VehicleDescription vehicle = random.uniform() < 0.5 ? cart() : mini_vehicle();
  const SpeedParams params{.speed_mps = random.uniform(0.1, 2)};
  constexpr double kPart_m = 0.01;
  double before_mps = speed_along(path, 0, 1, vehicle, params);
  for (double along_m = kPart_m; along_m < path.length_m(); along_m += kPart_m) {
    const PathPiece& piece = path.pieces()[path.at(along_m).piece];
    const double speed_mps = speed_along(path, along_m, 1, vehicle, params);
    RC_ASSERT(speed_mps > 0 && speed_mps <= params.speed_mps);
    RC_ASSERT(speed_mps <= vehicle.limits.speed_max_mps);
    if (piece.arc.length_m < 0) RC_ASSERT(speed_mps <= vehicle.limits.reverse_speed_max_mps);
    if (vehicle.is_differential) {
      RC_ASSERT(speed_mps * std::abs(piece.curvature_per_m()) <= vehicle.limits.turn_rate_max_rad_s + 1e-9);
    }
    RC_ASSERT(speed_along(path, along_m, 0.3, vehicle, params) <= speed_mps);
    const double braked2 = before_mps * before_mps - speed_mps * speed_mps;
    const double stop_m2_s2 = params.speed_min_mps * params.speed_min_mps;
    RC_ASSERT(braked2 <= 2 * params.deceleration_mps2 * kPart_m + stop_m2_s2 + 1e-9);
    before_mps = speed_mps;
  }
}

}  // namespace
}  // namespace aisle
