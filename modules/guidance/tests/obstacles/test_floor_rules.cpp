#include "aisle/guidance/obstacles/floor_rules.hpp"

#include <gtest/gtest.h>

#include "free_floor.hpp"

namespace aisle {
namespace {

Building with_line_across() {
  Building building;
  building.barriers = {{.segment = {{3, -1}, {3, 1}}}};
  return building;
}

/// From x = 3 m to 5 m, right across the path along the x axis.
Building with_zone(Zone zone) {
  zone.outline = {{3, -1}, {5, -1}, {5, 1}, {3, 1}};
  Building building;
  building.zones = {std::move(zone)};
  return building;
}

Decision obeyed(const Building& building, const Pose2& T_map_vehicle, const Command& command,
                const VehicleDescription& vehicle = cart()) {
  return FloorRules(building, vehicle)
      .obey({.command = command, .state = "following", .why = ""}, T_map_vehicle);
}

bool must_stop(double x_m, const Command& command) {
  return obeyed(with_line_across(), {x_m, 0, 0}, command).status == NavigatorStatus::kFailed;
}

TEST(FloorRules, StopAVehicleBeforeItIsTooLateToBrake) {
  const double front_m = cart().footprint.front_m;
  EXPECT_FALSE(must_stop(0, {.speed_mps = 0.5}));
  EXPECT_TRUE(must_stop(3 - front_m - 0.1, {.speed_mps = 0.5}));
  EXPECT_FALSE(must_stop(3 - front_m - 0.1, {.speed_mps = 0.1})) << "slow enough";
  EXPECT_FALSE(must_stop(3 - front_m - 0.1, {.speed_mps = -0.5})) << "away from it";
}

TEST(FloorRules, LookWhereTheVehicleGoes) {
  const Pose2 T_map_vehicle{1.7, -0.9, -0.2};
  EXPECT_EQ(obeyed(with_line_across(), T_map_vehicle, {.speed_mps = 0.5, .steering_rad = -0.7}).status,
            NavigatorStatus::kGoing);
}

TEST(FloorRules, IgnoreAStandingVehicle) {
  EXPECT_FALSE(must_stop(2.9, {}));
}

TEST(FloorRules, SlowAVehicleInASlowZoneAndBeforeItAndNowhereElse) {
  const Building building = with_zone({.kind = Zone::Kind::kSlow, .speed_max_mps = 0.1});
  const double front_m = cart().footprint.front_m, rear_m = cart().footprint.rear_m;
  const auto speed_at = [&](double x_m, double speed_mps) {
    return obeyed(building, {x_m, 0, 0}, {.speed_mps = speed_mps}).command.speed_mps;
  };
  EXPECT_DOUBLE_EQ(speed_at(3 - front_m - 0.1, 0.5), 0.1) << "it must brake now";
  EXPECT_DOUBLE_EQ(speed_at(4, 0.5), 0.1);
  EXPECT_DOUBLE_EQ(speed_at(4, -0.5), -0.1);
  EXPECT_DOUBLE_EQ(speed_at(4, 0.05), 0.05);
  EXPECT_DOUBLE_EQ(speed_at(5 + rear_m + 0.01, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(speed_at(1, 0.5), 0.5);
}

TEST(FloorRules, SlowATurningVehicleAlongTheSameArc) {
  const Building building = with_zone({.kind = Zone::Kind::kSlow, .speed_max_mps = 0.1});
  const Command command =
      obeyed(building, {4, 0, 0}, {.speed_mps = 0.4, .turn_rate_rad_s = 0.2}, differential_cart()).command;
  EXPECT_DOUBLE_EQ(command.speed_mps, 0.1);
  EXPECT_DOUBLE_EQ(command.turn_rate_rad_s, 0.05);
  const Command on_the_spot =
      obeyed(building, {4, 0, 0}, {.turn_rate_rad_s = 0.2}, differential_cart()).command;
  EXPECT_DOUBLE_EQ(on_the_spot.turn_rate_rad_s, 0.2);
}

TEST(FloorRules, StopAVehicleThatDrivesAgainstAOneWayZone) {
  const Building building = with_zone({.kind = Zone::Kind::kOneWay, .name = "ramp", .direction_rad = kPi});
  const Decision decision = obeyed(building, {3.5, 0, 0}, {.speed_mps = 0.3});
  EXPECT_EQ(decision.status, NavigatorStatus::kFailed);
  EXPECT_EQ(decision.why, "would drive against the one-way zone 'ramp'");
  EXPECT_EQ(decision.command, Command{});
  EXPECT_EQ(obeyed(building, {3.5, 0, 0}, {.speed_mps = -0.3}).status, NavigatorStatus::kGoing)
      << "in reverse";
  EXPECT_EQ(obeyed(building, {3.5, 0, kPi}, {.speed_mps = 0.3}).status, NavigatorStatus::kGoing);
  EXPECT_EQ(obeyed(building, {3.5, 0, kPi / 2}, {.speed_mps = 0.3}).status, NavigatorStatus::kGoing)
      << "across";
}

TEST(FloorRules, LetNoVehicleDriveInAKeepOutZone) {
  const Building building = with_zone({.kind = Zone::Kind::kKeepOut, .name = "lab"});
  const Decision decision = obeyed(building, {4, 0, 0}, {.speed_mps = 0.3});
  EXPECT_EQ(decision.status, NavigatorStatus::kFailed);
  EXPECT_EQ(decision.why, "is in the keep-out zone 'lab'");
  EXPECT_EQ(obeyed(building, {0, 0, 0}, {.speed_mps = 0.3}).status, NavigatorStatus::kGoing);
}

}  // namespace
}  // namespace aisle
