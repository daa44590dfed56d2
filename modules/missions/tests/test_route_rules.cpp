#include <gmock/gmock.h>

#include <utility>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/missions/route_rules.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

const Footprint kCart{.front_m = 0.9, .rear_m = 0.2, .width_m = 0.6};

/// Ten metres ahead.
Path straight_from(double x_m) {
  return Path(std::vector<PathPiece>{{.T_map_start = {x_m, 0, 0}, .arc = {10, 0}}});
}
Path straight() {
  return straight_from(0);
}

TEST(RouteRules, ARouteThatMeetsOneIsRefusedWithItsKindAndPlace) {
  Building building;
  building.barriers = {{.segment = {{-5, 3}, {15, 3}}},
                       {.kind = Barrier::Kind::kGlass, .segment = {{5.98, -1}, {5.98, 0.2}}}};
  const Problems problems = check_floor_rules(building, "to the desk", straight(), kCart);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(to_string(problems),
              HasSubstr("'to the desk' meets a barrier of the building (glass) near 5.1, 0.0"));
}

TEST(RouteRules, ARouteBesideThemIsDriven) {
  Building building;
  EXPECT_TRUE(check_floor_rules(building, "a", straight(), kCart).empty());
  building.barriers = {{.segment = {{-5, 0.35}, {15, 0.35}}}, {.segment = {{11, -1}, {11, 1}}}};
  EXPECT_TRUE(check_floor_rules(building, "a", straight(), kCart).empty());
}

/// From x = 4 m to 6 m, across the route.
Building with_zone_across(Zone zone) {
  zone.outline = {{4, -2}, {6, -2}, {6, 2}, {4, 2}};
  Building building;
  building.zones = {std::move(zone)};
  return building;
}

TEST(RouteRules, ARouteIntoAKeepOutZoneIsRefused) {
  const Building building = with_zone_across({.kind = Zone::Kind::kKeepOut, .name = "lab"});
  EXPECT_THAT(to_string(check_floor_rules(building, "a", straight(), kCart)),
              HasSubstr("keep-out line) near 3.1"));
  EXPECT_THAT(to_string(check_floor_rules(building, "a", straight_from(4.9), kCart)),
              HasSubstr("'a' leads through the keep-out zone 'lab' near 4.9, 0.0"));
}

TEST(RouteRules, ARouteAgainstAOneWayZoneIsRefused) {
  Zone zone{.kind = Zone::Kind::kOneWay, .direction_rad = kPi};
  EXPECT_THAT(to_string(check_floor_rules(with_zone_across(zone), "a", straight(), kCart)),
              HasSubstr("'a' leads against the one-way zone near 4.0, 0.0"));
  zone.direction_rad = 0;
  EXPECT_TRUE(check_floor_rules(with_zone_across(zone), "a", straight(), kCart).empty());
}

TEST(RouteRules, ARouteThroughASlowZoneIsDriven) {
  EXPECT_TRUE(
      check_floor_rules(with_zone_across({.kind = Zone::Kind::kSlow}), "a", straight(), kCart).empty());
}

}  // namespace
}  // namespace aisle
