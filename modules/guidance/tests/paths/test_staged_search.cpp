#include <gtest/gtest.h>

#include "aisle/guidance/paths/staged_search.hpp"
#include "free_floor.hpp"

namespace aisle {
namespace {

constexpr double kStage_m = 6;

/// A corridor 30 m long in which the vehicle can turn round only at the far end.
class LongCorridor : public testing::TestWithParam<bool> {
 protected:
  KnownFloor known = free_floor({{Vec2(0, 0), Vec2(30, 1.1)}, {Vec2(27, 0), Vec2(30, 4)}});
  StagedSearch search{{.stage_m = kStage_m}, cart_of(GetParam())};

  Path found() { return search.advance(known, 1000000) == CarSearch::State::kFound ? search.path() : Path(); }
};

INSTANTIATE_TEST_SUITE_P(, LongCorridor, testing::Bool(), name_of_drive);

TEST_P(LongCorridor, LeadsOneStageTowardsADistantGoal) {
  const Vec2 p_map_place(28, 0.5);
  search.look_for(known, {2, 0.55, 0}, p_map_place, 0, [](const Pose2& T) { return T.x > 26; });
  const Path path = found();
  EXPECT_TRUE(search.is_stage());
  EXPECT_GE(path.length_m(), kStage_m - 0.5);
  EXPECT_LE(path.length_m(), kStage_m + 1);
}

TEST_P(LongCorridor, LeadsToTheGoalStageByStage) {
  Pose2 T_map{2, 0.55, 0};
  int stages = 0;
  bool is_stage = true;
  for (; is_stage && stages < 10; ++stages) {
    search.look_for(known, T_map, {28, 0.5}, 0, [](const Pose2& T) { return T.x > 26; });
    const Path path = found();
    ASSERT_FALSE(path.empty());
    T_map = path.end();
    is_stage = search.is_stage();
  }
  EXPECT_GT(T_map.x, 26);
  EXPECT_GE(stages, 3);
  EXPECT_LE(stages, 5);
}

TEST_P(LongCorridor, EndsExactlyAtANearPose) {
  const Pose2 T_map_goal{4, 0.5, 0};
  search.look_for_path_to(known, T_map_goal, {10, 0.55, 0});
  const Path path = found();
  ASSERT_FALSE(path.empty());
  EXPECT_FALSE(search.is_stage());
  EXPECT_LT(between(T_map_goal, path.end()).position().norm(), 1e-6);
}

TEST(StagedSearch, FindsNoPathOutOfAClosedRoom) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(4, 3)}, {Vec2(6, 0), Vec2(9, 3)}});
  StagedSearch search({.stage_m = kStage_m}, cart());
  search.look_for(known, {1, 1, 0}, {8, 1}, 0, [](const Pose2& T) { return T.x > 7; });
  EXPECT_EQ(search.advance(known, 1000000), CarSearch::State::kNone);
}

/// A hall with more poses than a search ever tries, and off it a dead-end corridor. Near the corridor's end,
/// a door opens into a room: from a corridor 1.35 m wide the vehicle can just turn in, from one of 1 m it
/// cannot.
struct HallAndRoom {
  explicit HallAndRoom(double corridor_m)
      : known(free_floor({{Vec2(0, 0), Vec2(20, 20)},
                          {Vec2(-7, 5.35 - corridor_m), Vec2(0, 5.35)},
                          {Vec2(-6.75, 5.35), Vec2(-5.8, 5.5)},
                          {Vec2(-7, 5.5), Vec2(-3, 8)}})) {
    search.look_for(known, {5, 5, 0}, {-5, 7}, 0, is_in_the_room);
  }

  void search_from_ends_too() {
    search.search_from_ends_too({known.grid().cell_at({-8, 4}), known.grid().cell_at({-2, 9})});
  }
  CarSearch::State search_in_portions() {
    while (search.advance(known, 1500) == CarSearch::State::kSearching) continue;
    return search.state();
  }

  static bool is_in_the_room(const Pose2& T) { return T.x < 0 && T.y > 6.5; }

  KnownFloor known;
  StagedSearch search{{.stage_m = 100, .expansions_max = 40000}, cart()};
};

TEST(StagedSearch, FindsByTheBackwardSearchARoomThatIsHardToEnter) {
  HallAndRoom one_direction(1.35);
  EXPECT_EQ(one_direction.search_in_portions(), CarSearch::State::kNone);
  HallAndRoom both_directions(1.35);
  both_directions.search_from_ends_too();
  ASSERT_EQ(both_directions.search_in_portions(), CarSearch::State::kFound);
  const Path path = both_directions.search.path();
  EXPECT_TRUE(HallAndRoom::is_in_the_room(path.at(path.length_m()).T_map_path));
  EXPECT_LT((path.at(0).T_map_path.position() - Vec2(5, 5)).norm(), 0.13);
}

TEST(StagedSearch, KnowsByTheBackwardSearchThatNoPathLeadsThere) {
  const Vec2 p_map_home(18, 18);
  HallAndRoom one_direction(1);
  EXPECT_EQ(one_direction.search_in_portions(), CarSearch::State::kNone);
  EXPECT_FALSE(one_direction.search.has_tried_all());
  EXPECT_FALSE(one_direction.search.is_shut_off_from(p_map_home, 1));
  HallAndRoom both_directions(1);
  both_directions.search_from_ends_too();
  EXPECT_EQ(both_directions.search_in_portions(), CarSearch::State::kNone);
  EXPECT_TRUE(both_directions.search.is_shut_off_from(p_map_home, 1));
  EXPECT_FALSE(both_directions.search.is_shut_off_from({-5, 7}, 1));
  EXPECT_TRUE(both_directions.search.is_shut_off_from({-5, 7}, 5)) << "the vehicle, too, can get that near";
}

}  // namespace
}  // namespace aisle
