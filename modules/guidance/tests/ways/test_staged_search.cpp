#include <gtest/gtest.h>

#include "aisle/guidance/ways/staged_search.hpp"
#include "known_floor.hpp"

namespace aisle {
namespace {

constexpr double kStage_m = 6;

/// A corridor of 30 m, in which the vehicle can turn round only at its far end.
struct LongCorridor {
  KnownFloor known = KnownFloor({{Vec2(0, 0), Vec2(30, 1.1)}, {Vec2(27, 0), Vec2(30, 4)}});
  StagedSearch search{{.stage_m = kStage_m}, cart()};

  Path found() {
    return search.advance(known.floor, known.clearance, 1000000) == CarSearch::State::kFound ? search.path()
                                                                                             : Path();
  }
};

TEST(StagedSearch, LeadsAStageTowardsWhatIsFar) {
  LongCorridor corridor;
  const Vec2 p_map_place(28, 0.5);
  corridor.search.look_for(corridor.known.floor, corridor.known.clearance, {2, 0.55, 0}, p_map_place, 0,
                           [](const Pose2& T) { return T.x > 26; });
  const Path path = corridor.found();
  EXPECT_TRUE(corridor.search.is_stage());
  EXPECT_GE(path.length_m(), kStage_m - 0.5);
  EXPECT_LE(path.length_m(), kStage_m + 1);
}

TEST(StagedSearch, LeadsToTheGoalStageByStage) {
  LongCorridor corridor;
  Pose2 T_map{2, 0.55, 0};
  int stages = 0;
  bool is_stage = true;
  for (; is_stage && stages < 10; ++stages) {
    corridor.search.look_for(corridor.known.floor, corridor.known.clearance, T_map, {28, 0.5}, 0,
                             [](const Pose2& T) { return T.x > 26; });
    const Path path = corridor.found();
    ASSERT_FALSE(path.empty());
    T_map = path.at(path.length_m()).T_map_path;
    is_stage = corridor.search.is_stage();
  }
  EXPECT_GT(T_map.x, 26);
  EXPECT_GE(stages, 3);
  EXPECT_LE(stages, 5);
}

TEST(StagedSearch, EndsExactlyAtAPoseThatIsNear) {
  LongCorridor corridor;
  const Pose2 T_map_goal{4, 0.5, 0};
  corridor.search.look_for_way_to(corridor.known.floor, corridor.known.clearance, T_map_goal, {10, 0.55, 0});
  const Path path = corridor.found();
  ASSERT_FALSE(path.empty());
  EXPECT_FALSE(corridor.search.is_stage());
  EXPECT_LT(between(T_map_goal, path.at(path.length_m()).T_map_path).position().norm(), 1e-6);
}

TEST(StagedSearch, FindsNoWayOutOfARoomThatIsClosed) {
  const KnownFloor known({{Vec2(0, 0), Vec2(4, 3)}, {Vec2(6, 0), Vec2(9, 3)}});
  StagedSearch search({.stage_m = kStage_m}, cart());
  search.look_for(known.floor, known.clearance, {1, 1, 0}, {8, 1}, 0, [](const Pose2& T) { return T.x > 7; });
  EXPECT_EQ(search.advance(known.floor, known.clearance, 1000000), CarSearch::State::kNone);
}

}  // namespace
}  // namespace aisle
