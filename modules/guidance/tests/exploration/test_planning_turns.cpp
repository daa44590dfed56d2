#include "aisle/guidance/exploration/planning_turns.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

using Turn = PlanningTurns::Turn;

TEST(PlanningTurns, AfterNewFloorItLooksAroundThenChoosesThenSearches) {
  PlanningTurns turns;
  EXPECT_EQ(turns.next(true, true), Turn::kSearch) << "the floor was learned in this cycle";
  EXPECT_EQ(turns.next(false, true), Turn::kLookAround);
  EXPECT_EQ(turns.next(false, true), Turn::kChoose);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(turns.next(false, true), Turn::kSearch);
}

TEST(PlanningTurns, WithoutATargetItLooksAroundAgain) {
  PlanningTurns turns;
  EXPECT_EQ(turns.next(true, false), Turn::kSearch);
  EXPECT_EQ(turns.next(false, false), Turn::kLookAround);
  EXPECT_EQ(turns.next(false, false), Turn::kChoose);
  EXPECT_EQ(turns.next(false, false), Turn::kSearch);
  EXPECT_EQ(turns.next(false, false), Turn::kLookAround);
}

TEST(PlanningTurns, NewsInEveryCycleLeavesATurnForTheSearch) {
  PlanningTurns turns;
  turns.next(true, true);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(turns.next(true, true), Turn::kLookAround);
    EXPECT_EQ(turns.next(true, true), Turn::kChoose);
    EXPECT_EQ(turns.next(true, true), Turn::kSearch);
  }
}

TEST(PlanningTurns, ALookAtTheFormerFloorIsForgotten) {
  PlanningTurns turns;
  turns.next(true, true);
  ASSERT_EQ(turns.next(false, true), Turn::kLookAround);
  turns.forget_look();
  EXPECT_EQ(turns.next(true, true), Turn::kSearch);
  EXPECT_EQ(turns.next(false, true), Turn::kLookAround);
}

}  // namespace
}  // namespace aisle
