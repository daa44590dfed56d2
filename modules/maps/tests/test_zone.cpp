#include "aisle/maps/zone.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

const Footprint kZoneCart{.front_m = 0.9, .rear_m = 0.2, .width_m = 0.6};

/// An L: three metres to the right and up, one metre wide.
Zone l_zone(Zone::Kind kind) {
  return {.kind = kind, .outline = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
}

TEST(Zone, ContainsWhatItsOutlineEncloses) {
  const Zone zone = l_zone(Zone::Kind::kSlow);
  EXPECT_TRUE(contains(zone, {0.5, 0.5}));
  EXPECT_TRUE(contains(zone, {2.5, 0.5}));
  EXPECT_TRUE(contains(zone, {0.5, 2.5}));
  EXPECT_FALSE(contains(zone, {2, 2})) << "in the L's corner";
  EXPECT_FALSE(contains(zone, {-0.1, 0.5}));
  EXPECT_FALSE(contains(zone, {0.5, 3.1}));
}

RC_GTEST_PROP(Zone, ContainsThePointsOfARectangleHoweverItIsTurned,
              (std::int16_t turn, std::int16_t x, std::int16_t y)) {
  const Pose2 T_map_zone{3, -2, turn * 0.001};
  const Vec2 p_zone(x * 1e-4, y * 1e-4);
  const Zone zone{.outline = {T_map_zone * Vec2(-2, -1), T_map_zone * Vec2(2, -1), T_map_zone * Vec2(2, 1),
                              T_map_zone * Vec2(-2, 1)}};
  const double beyond_m = std::max(std::abs(p_zone.x()) - 2, std::abs(p_zone.y()) - 1);
  RC_PRE(std::abs(beyond_m) > 1e-9);
  RC_ASSERT(contains(zone, T_map_zone * p_zone) == (beyond_m < 0));
}

TEST(Zone, LimitsTheSpeedOfAVehicleOfWhichAnyPartIsInside) {
  Zone slow = l_zone(Zone::Kind::kSlow);
  slow.speed_max_mps = 0.15;
  const std::vector<Zone> zones = {slow};
  EXPECT_EQ(speed_max_mps(zones, kZoneCart, {-0.85, 0.5, 0}), 0.15) << "its front";
  EXPECT_EQ(speed_max_mps(zones, kZoneCart, {3.1, 0.5, 0}), 0.15) << "its rear";
  EXPECT_TRUE(std::isinf(speed_max_mps(zones, kZoneCart, {3.3, 0.5, 0})));
  EXPECT_TRUE(std::isinf(speed_max_mps(zones, kZoneCart, {-1, 0.5, 0})));
}

TEST(Zone, OfAKindThatHasNoSpeedLimitsNone) {
  const std::vector<Zone> zones = {l_zone(Zone::Kind::kKeepOut), l_zone(Zone::Kind::kOneWay)};
  EXPECT_TRUE(std::isinf(speed_max_mps(zones, kZoneCart, {0.5, 0.5, 0})));
}

TEST(Zone, IsOneWayForWhoIsInside) {
  Zone zone = l_zone(Zone::Kind::kOneWay);
  zone.direction_rad = 170 * kDegree;
  const std::vector<Zone> zones = {zone};
  const auto against = [&](const Pose2& T_map_vehicle, Gear gear) {
    return one_way_against(zones, T_map_vehicle, gear);
  };
  EXPECT_EQ(against({0.5, 0.5, 0}, Gear::kForward), &zones[0]);
  EXPECT_EQ(against({0.5, 0.5, 0}, Gear::kReverse), nullptr) << "backs along it";
  EXPECT_EQ(against({0.5, 0.5, -170 * kDegree}, Gear::kForward), nullptr) << "20 degrees off";
  EXPECT_EQ(against({0.5, 0.5, -170 * kDegree}, Gear::kReverse), &zones[0]);
  EXPECT_EQ(against({0.5, 0.5, 80 * kDegree}, Gear::kForward), nullptr) << "across";
  EXPECT_EQ(against({2, 2, 0}, Gear::kForward), nullptr) << "outside";
}

TEST(Zone, ToKeepOutOfHasBarriersAllAround) {
  const std::vector<Zone> zones = {l_zone(Zone::Kind::kKeepOut), l_zone(Zone::Kind::kSlow)};
  const std::vector<Barrier> barriers = outlines(zones);
  ASSERT_EQ(barriers.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(barriers[i].segment.end, barriers[(i + 1) % 6].segment.start) << i;
}

}  // namespace
}  // namespace aisle
