#include <gmock/gmock.h>

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/simulation/plans/plan_symbols.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

void draw(FloorPlan& plan, int x0, int y0, int x1, int y1) {
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) plan.solid[plan.index(x, y)] = 1;
  }
}

/// Two rooms of thick walls, with a gap of 20 cells between them at x = 60 to 63, y = 30 to 50.
FloorPlan two_rooms() {
  FloorPlan plan(123, 83, 0);
  draw(plan, 0, 0, 123, 3);
  draw(plan, 0, 80, 123, 83);
  draw(plan, 0, 0, 3, 83);
  draw(plan, 120, 0, 123, 83);
  draw(plan, 60, 0, 63, 30);
  draw(plan, 60, 50, 63, 83);
  return plan;
}

/// A leaf and a quarter arc about (62, 50), into the right room.
void draw_door(FloorPlan& plan) {
  draw(plan, 62, 50, 82, 51);
  for (double angle = 0; angle <= 90; angle += 0.5) {
    const int x = static_cast<int>(std::lround(62 + 20 * std::cos(angle * kDegree)));
    const int y = static_cast<int>(std::lround(50 - 20 * std::sin(angle * kDegree)));
    plan.solid[plan.index(x, y)] = 1;
  }
}

/// map2gazebo#3, linorobot2#196: the arc of a drawn door shut half of the building off.
TEST(PlanSymbols, ADoorOfLeafAndArcIsOpened) {
  FloorPlan plan = two_rooms();
  draw_door(plan);
  const PlanSymbols symbols = open_drawn_doors(plan);
  ASSERT_THAT(symbols.doors, SizeIs(1));
  EXPECT_EQ(plan.solid, two_rooms().solid);
}

TEST(PlanSymbols, AnotherThinLineStays) {
  FloorPlan plan = two_rooms();
  draw(plan, 61, 30, 62, 50);  // a closed door: a line across the gap
  const FloorPlan before = plan;
  const PlanSymbols symbols = open_drawn_doors(plan);
  EXPECT_THAT(symbols.doors, IsEmpty());
  EXPECT_EQ(plan.solid, before.solid);
}

TEST(PlanSymbols, LettersAreMarksAndPillarsAreNot) {
  FloorPlan plan = two_rooms();
  for (const int x : {20, 30}) {  // H
    draw(plan, x, 20, x + 1, 29);
    draw(plan, x + 4, 20, x + 5, 29);
    draw(plan, x, 24, x + 5, 25);
  }
  draw(plan, 40, 40, 44, 44);  // a pillar
  draw(plan, 50, 20, 51, 21);  // a pillar of one cell
  const PlanSymbols symbols = open_drawn_doors(plan);
  EXPECT_THAT(symbols.marks, SizeIs(2));
  EXPECT_TRUE(plan.is_solid(20, 20));
}

TEST(PlanSymbols, WhereWallsAreSingleLinesNothingIsTakenForASymbol) {
  FloorPlan plan(123, 83, 0);
  draw(plan, 5, 5, 100, 6);
  draw_door(plan);
  const PlanSymbols symbols = open_drawn_doors(plan);
  EXPECT_THAT(symbols.doors, IsEmpty());
}

}  // namespace
}  // namespace aisle
