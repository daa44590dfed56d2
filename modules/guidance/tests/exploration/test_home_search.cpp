#include "aisle/guidance/exploration/home_search.hpp"

#include <gtest/gtest.h>

#include "free_floor.hpp"

namespace aisle {
namespace {

class PathsHome : public testing::TestWithParam<bool> {
 protected:
  Path found() {
    EXPECT_EQ(search_.advance(known_, 200000), CarSearch::State::kFound);
    return home_search_.path();
  }

  KnownFloor known_ = free_floor({{Vec2(0, 0), Vec2(10, 3)}});
  StagedSearch search_{{}, cart_of(GetParam())};
  HomeSearch home_search_{search_};
  Pose2 T_map_home_{2.5, 1.5, 0};
};

INSTANTIATE_TEST_SUITE_P(, PathsHome, testing::Bool(), name_of_drive);

TEST_P(PathsHome, EndExactlyThereAfterAStraightMetre) {
  for (const double from_x_m : {0.5, 6.5}) {
    const Pose2 T_map_from{from_x_m, 1.2, 0};
    home_search_.look_for(known_, T_map_home_, T_map_from,
                          home_search_.straight_in(known_, T_map_home_, T_map_from));
    const Path path = found();
    EXPECT_TRUE(home_search_.leads_home());
    ASSERT_FALSE(path.empty());
    const Pose2 off = between(T_map_home_, path.end());
    EXPECT_LT(off.position().norm(), 1e-6);
    EXPECT_NEAR(off.theta, 0, 1e-6);
    EXPECT_NEAR(path.pieces().back().arc.length_m, from_x_m < T_map_home_.x ? 1 : -1, 0.3);
    EXPECT_NEAR(path.pieces().back().arc.turn_rad, 0, 1e-9);
  }
}

TEST_P(PathsHome, LeadInTheWayThatIsGiven) {
  const Path way_in({PathPiece{{3.5, 2, 0}, {-1.1, 0.3}}});
  home_search_.look_for(known_, way_in.end(), {7, 1.5, 0}, way_in);
  const Path path = found();
  EXPECT_TRUE(home_search_.leads_home());
  EXPECT_LT(between(way_in.end(), path.end()).position().norm(), 1e-6);
  EXPECT_NEAR(path.pieces().back().arc.length_m, -1.1, 1e-9);
  EXPECT_NEAR(path.pieces().back().arc.turn_rad, 0.3, 1e-9);
}

TEST_P(PathsHome, HaveNoStraightMetreWhereThereIsNoSpaceForIt) {
  known_ = free_floor({{Vec2(2, 0), Vec2(4, 3)}});
  EXPECT_TRUE(home_search_.straight_in(known_, {2.5, 1.5, kPi / 4}, {3, 2, 0}).empty());
}

TEST_P(PathsHome, NearHomeIsNotHome) {
  home_search_.look_for_near(known_, T_map_home_, {7, 1.5, 0});
  const Path path = found();
  EXPECT_FALSE(home_search_.leads_home());
  ASSERT_FALSE(path.empty());
  const Pose2 off = between(T_map_home_, path.end());
  EXPECT_LT(off.position().norm(), HomeSearch::kNear_m);
  EXPECT_FALSE(stands_at_home(T_map_home_, path.end()));
}

TEST_P(PathsHome, AStageOfAFarPathDoesNotLeadHomeYet) {
  known_ = free_floor({{Vec2(0, 0), Vec2(40, 3)}});
  home_search_.look_for(known_, T_map_home_, {37, 1.5, kPi}, {});
  found();
  EXPECT_FALSE(home_search_.leads_home());
}

TEST(StandsAtHome, WithinAFewCentimetresAndADegree) {
  const Pose2 T_map_home{1, 2, kPi / 2};
  EXPECT_TRUE(stands_at_home(T_map_home, {1.02, 2.015, kPi / 2 + 0.5 * kDegree}));
  EXPECT_FALSE(stands_at_home(T_map_home, {1.04, 2, kPi / 2}));
  EXPECT_FALSE(stands_at_home(T_map_home, {1, 2, kPi / 2 + 2 * kDegree}));
}

}  // namespace
}  // namespace aisle
