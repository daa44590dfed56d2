#include <gmock/gmock.h>

#include <vector>

#include "aisle/missions/route_name.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

const Footprint kCart{.front_m = 0.9, .rear_m = 0.2, .width_m = 0.6};

/// Ten metres ahead from the origin.
Path straight() {
  return Path(std::vector<PathPiece>{{.T_map_start = {}, .arc = {10, 0}}});
}

TEST(RouteBarriers, ARouteThatMeetsOneIsRefusedWithItsKindAndPlace) {
  Building building;
  building.barriers = {{.segment = {{-5, 3}, {15, 3}}},
                       {.kind = Barrier::Kind::kGlass, .segment = {{5.98, -1}, {5.98, 0.2}}}};
  const Problems problems = check_barriers(building, "to the desk", straight(), kCart);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(to_string(problems),
              HasSubstr("'to the desk' meets a barrier of the building (glass) near 5.1, 0.0"));
}

TEST(RouteBarriers, ARouteBesideThemIsDriven) {
  Building building;
  EXPECT_TRUE(check_barriers(building, "a", straight(), kCart).empty());
  building.barriers = {{.segment = {{-5, 0.35}, {15, 0.35}}}, {.segment = {{11, -1}, {11, 1}}}};
  EXPECT_TRUE(check_barriers(building, "a", straight(), kCart).empty());
}

}  // namespace
}  // namespace aisle
