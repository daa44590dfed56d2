#include "aisle/control/steering.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "closed_loop.hpp"

namespace aisle {
namespace {

const Pose2 kTenCentimetresAndFiveDegreesOff{0, 0.1, 5 * kDegree};

Path two_bends(double radius_m, double direction = 1) {
  const Arc line{direction * 4, 0}, left{direction * radius_m * kPi / 2, kPi / 2},
      right{direction * radius_m * kPi / 2, -kPi / 2};
  return path_of({line, left, line, right, line});
}

ClosedLoop driven(const VehicleDescription& vehicle, const Path& path, double speed_mps,
                  const Pose2& T_map_start = {}, double steering_bias_rad = 0) {
  ClosedLoop loop{.vehicle = vehicle, .speed = {.speed_mps = speed_mps}};
  loop.T_map_vehicle = T_map_start;
  loop.steering_bias_rad = steering_bias_rad;
  loop.drive_along(path);
  return loop;
}

/// How far the vehicle overshoots to the other side of the path.
double overshoot_m(const ClosedLoop& loop) {
  double over_m = 0;
  for (const DrivenCycle& cycle : loop.cycles) over_m = std::max(over_m, -cycle.lateral_m);
  return over_m;
}

TEST(SteeringCost, IsZeroOnALine) {
  const FrontSteered vehicle{0.75};
  const Path path = path_of({{10, 0}});
  EXPECT_NEAR(steering_cost(vehicle, path, path.at(5), {5, 0, 0}, 0.6, 0), 0, 1e-12);
  EXPECT_NEAR(steering_cost(vehicle, path, path.at(5), {5, 0.1, 0}, 0.6, 0), 0.2, 1e-12);
}

TEST(SteeringCost, IsZeroOnAnArcForTheSteeringThatDrivesIt) {
  const FrontSteered vehicle{0.75};
  for (const double direction : {1.0, -1.0}) {
    const Path path = path_of({{direction * 3, direction * 3}});
    EXPECT_NEAR(steering_cost(vehicle, path, path.at(1), path.at(1).T_map_path, 0.6, std::atan(0.75)), 0,
                1e-12);
  }
}

RC_GTEST_PROP(PathFollower, GivesTheAngleThatTryingAllGives, (std::uint64_t seed)) {
  Random random(seed);
  const VehicleDescription vehicle = cart();
  const Path path = two_bends(random.uniform(0.5, 2));
  const PathPoint from = path.at(random.uniform(0, path.length_m()));
  const Pose2 T_map_vehicle =
      from.T_map_path * Pose2{random.normal(0.1), random.normal(0.3), random.normal(0.5)};
  const double steering_rad = random.uniform(-45, 45) * kDegree, speed_mps = random.uniform(0, 1);
  const SteeringParams params;
  const Command found =
      PathFollower(vehicle, params).follow(path, from, T_map_vehicle, speed_mps, steering_rad);

  const double look_ahead_m = params.look_ahead_m + params.look_ahead_s * speed_mps;
  const double max_rad = vehicle.limits.steering_max_rad;
  const double now_rad = std::clamp(steering_rad, -max_rad, max_rad);
  const double change_rad = vehicle.limits.steering_rate_max_rad_s * vehicle.cycle_s;
  double best_rad = 0, best = 1e9;
  for (int i = 0; i <= 400; ++i) {
    for (const int side : {1, -1}) {
      const double tried_rad = side * i * params.angle_step_rad;
      if (std::abs(tried_rad - now_rad) > change_rad + 1e-9) continue;
      const double cost =
          steering_cost(vehicle.front_steered, path, from, T_map_vehicle, look_ahead_m, tried_rad);
      if (cost >= best) continue;
      best = cost;
      best_rad = tried_rad;
    }
  }
  RC_ASSERT(found.steering_rad == best_rad);
}

/// A path that the vehicle can drive: lines and arcs either way, and turns on the spot if it can turn so.
Path any_drivable_path(const VehicleDescription& vehicle, Random& random) {
  std::vector<Arc> arcs;
  for (int i = 0; i < 6; ++i) {
    const double length_m = random.uniform(0.5, 2) * (random.uniform() < 0.3 ? -1 : 1);
    const double bend_per_m = random.uniform() < 0.4 ? 0 : random.uniform(-0.8, 0.8);
    arcs.push_back({length_m, length_m * bend_per_m});
    if (vehicle.is_differential && random.uniform() < 0.5) arcs.push_back({0, random.uniform(-3, 3)});
  }
  return path_of(arcs);
}

RC_GTEST_PROP(PathFollower, DrivesAnyPathToItsEndWithEitherDrive,
              (std::uint64_t seed, bool is_differential)) {
  Random random(seed);
  const VehicleDescription vehicle = is_differential ? mini_vehicle() : cart();
  const Path path = any_drivable_path(vehicle, random);
  const ClosedLoop loop = driven(vehicle, path, 0.2);
  RC_ASSERT(loop.arrived);
  RC_ASSERT((loop.T_map_vehicle.position() - path.end().position()).norm() < 0.15);
  RC_ASSERT(loop.lateral_max_m() < 0.25);
}

TEST(PathFollower, ConvergesToAStraightPathWithoutOscillating) {
  for (const double speed_mps : {0.3, 0.5, 1.0}) {
    const ClosedLoop loop = driven(cart(), path_of({{12, 0}}), speed_mps, kTenCentimetresAndFiveDegreesOff);
    EXPECT_TRUE(loop.arrived);
    EXPECT_LT(overshoot_m(loop), 0.001) << speed_mps;
    EXPECT_LT(loop.lateral_max_m(6), 0.001) << speed_mps;
  }
}

TEST(PathFollower, KeepsToBendsAndTheirBeginnings) {
  EXPECT_LT(driven(cart(), two_bends(1), 0.3).lateral_max_m(), 0.02);
  EXPECT_LT(driven(cart(), two_bends(1), 1.0).lateral_max_m(), 0.03);
  EXPECT_LT(driven(cart(), two_bends(1.5), 0.3).lateral_max_m(), 0.02);
  EXPECT_LT(driven(cart(), two_bends(1.5), 1.0).lateral_max_m(), 0.03);
}

TEST(PathFollower, ReversesAlongLinesAndBends) {
  const ClosedLoop line = driven(cart(), path_of({{-12, 0}}), 0.3, kTenCentimetresAndFiveDegreesOff);
  EXPECT_TRUE(line.arrived);
  EXPECT_LT(overshoot_m(line), 0.001);
  EXPECT_LT(line.lateral_max_m(8), 0.0015);
  for (const double radius_m : {1.0, 1.5}) {
    for (const double speed_mps : {0.15, 0.3, 0.5}) {
      const ClosedLoop bends = driven(cart(), two_bends(radius_m, -1), speed_mps);
      EXPECT_TRUE(bends.arrived);
      EXPECT_LT(bends.lateral_max_m(), 0.025) << radius_m << ' ' << speed_mps;
    }
  }
}

TEST(PathFollower, ASteeringBiasCostsMillimetres) {
  for (const double speed_mps : {0.3, 1.0}) {
    const ClosedLoop loop = driven(cart(), path_of({{12, 0}}), speed_mps, {}, 0.5 * kDegree);
    EXPECT_LT(loop.lateral_max_m(6), 0.01) << speed_mps;
  }
}

TEST(PathFollower, ADifferentialVehicleKeepsToLinesArcsAndTurnsOnTheSpot) {
  const ClosedLoop line = driven(mini_vehicle(), path_of({{4, 0}}), 0.2, kTenCentimetresAndFiveDegreesOff);
  EXPECT_TRUE(line.arrived);
  EXPECT_LT(overshoot_m(line), 0.001);
  EXPECT_LT(line.lateral_max_m(3), 0.001);
  const ClosedLoop bends = driven(mini_vehicle(), two_bends(1), 0.2);
  EXPECT_TRUE(bends.arrived);
  EXPECT_LT(bends.lateral_max_m(), 0.02);
  const ClosedLoop corner = driven(mini_vehicle(), path_of({{2, 0}, {0, kPi / 2}, {2, 0}}), 0.2);
  EXPECT_TRUE(corner.arrived);
  EXPECT_LT(corner.lateral_max_m(), 0.02);
  const ClosedLoop back = driven(mini_vehicle(), path_of({{-4, 0}}), 0.2, kTenCentimetresAndFiveDegreesOff);
  EXPECT_TRUE(back.arrived);
  EXPECT_LT(back.lateral_max_m(3.5), 0.001);
}

}  // namespace
}  // namespace aisle
