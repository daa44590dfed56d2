#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"
#include "plan_raster.hpp"

namespace aisle {
namespace {

std::vector<Segment2> traced(const FloorPlan& plan, double tolerance_cells = 1) {
  SilentProgress silent;
  return trace_plan(plan, {.tolerance_cells = tolerance_cells}, silent).value();
}

void fill(FloorPlan& plan, int x0, int y0, int x1, int y1, std::uint8_t value) {
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) plan.solid[plan.index(x, y)] = value;
  }
}

/// A room of w x h cells with its lower left corner at (x, y), in solid rock.
FloorPlan room(int x, int y, int w, int h) {
  FloorPlan plan(x + w + 7, y + h + 5, 1);
  fill(plan, x, y, x + w, y + h, 0);
  return plan;
}

/// Cells whose middles lie in this room, turned about the middle of the plan.
FloorPlan turned_room(int size, double width, double height, double heading_rad) {
  FloorPlan plan(size, size, 1);
  const Pose2 T_plan_room{size / 2.0, size / 2.0, heading_rad};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Vec2 p = T_plan_room.inverse() * Vec2(x + 0.5, y + 0.5);
      if (std::abs(p.x()) < width / 2 && std::abs(p.y()) < height / 2) plan.solid[plan.index(x, y)] = 0;
    }
  }
  return plan;
}

TEST(PlanTracing, ARoomIsFourWallsInItsPlaceWithTheFreeSideOnTheLeft) {
  FloorPlan plan = room(3, 2, 40, 20);
  plan.cell_m = 0.1;
  plan.T_world_plan = {10, 20, 0};
  const auto walls = traced(plan);
  ASSERT_EQ(walls.size(), 4);
  double area = 0;
  for (const Segment2& wall : walls) {
    area += (wall.start.x() * wall.end.y() - wall.start.y() * wall.end.x()) / 2;
    for (const double x : {wall.start.x(), wall.end.x()})
      EXPECT_LT(std::min(std::abs(x - 10.3), std::abs(x - 14.3)), 1e-9);
    for (const double y : {wall.start.y(), wall.end.y()})
      EXPECT_LT(std::min(std::abs(y - 20.2), std::abs(y - 22.2)), 1e-9);
  }
  EXPECT_NEAR(area, 4 * 2, 1e-9);
}

TEST(PlanTracing, APlanThatIsNotTurnedIsNotMirrored) {
  FloorPlan plan = room(2, 2, 30, 30);
  fill(plan, 2, 20, 12, 32, 1);  // the room has no upper left corner
  double area_left_above = 0;
  const FloorPlan drawn = drawn_plan(traced(plan), plan);
  for (int y = 20; y < 32; ++y) {
    for (int x = 2; x < 12; ++x) area_left_above += !drawn.is_solid(x, y);
  }
  EXPECT_EQ(area_left_above, 0);
  EXPECT_EQ(traced(plan).size(), 6);
}

/// A wall may be off the middles of the cells' sides by the tolerance, and these off the true wall by half
/// the diagonal of a cell.
constexpr double kOffMax_cells = 1 + 0.5 * std::numbers::sqrt2;

RC_GTEST_PROP(PlanTracing, ATurnedRoomIsFourStraightWallsWithinTheTolerance, ()) {
  const double heading_rad = *rc::gen::inRange(-4500, 4500) * 0.01 * kDegree;
  const double width = *rc::gen::inRange(400, 1800) * 0.1, height = *rc::gen::inRange(400, 1200) * 0.1;
  const FloorPlan plan = turned_room(260, width, height, heading_rad);
  const auto walls = traced(plan);
  RC_ASSERT(walls.size() == 4);
  const Pose2 T_plan_room{130, 130, heading_rad};
  for (const double x : {-width / 2, width / 2}) {
    for (const double y : {-height / 2, height / 2}) {
      const Vec2 corner = plan.cell_m * (T_plan_room * Vec2(x, y));
      const auto nearest =
          std::min_element(walls.begin(), walls.end(), [&](const Segment2& a, const Segment2& b) {
            return (a.start - corner).norm() < (b.start - corner).norm();
          });
      RC_ASSERT((nearest->start - corner).norm() < kOffMax_cells * plan.cell_m);
      RC_ASSERT(nearest->distance(corner) < kOffMax_cells * plan.cell_m);
    }
  }
}

/// Free rectangles on a coarse lattice: walls 4 cells thick or more wherever they do not touch.
RC_GTEST_PROP(PlanTracing, RectilinearFloorsComeBackExactly, ()) {
  FloorPlan plan(120, 90, 1);
  const int rooms = *rc::gen::inRange(1, 9);
  for (int i = 0; i < rooms; ++i) {
    const int x = 4 + 4 * *rc::gen::inRange(0, 20), y = 4 + 4 * *rc::gen::inRange(0, 14);
    fill(plan, x, y, std::min(x + 4 * *rc::gen::inRange(2, 12), 116),
         std::min(y + 4 * *rc::gen::inRange(2, 10), 84), 0);
  }
  const auto walls = traced(plan);
  RC_ASSERT(agreement(plan, walls).all == 1);
  for (const Segment2& wall : walls) {
    const Vec2 extent = (wall.end - wall.start).cwiseAbs() / plan.cell_m;
    RC_ASSERT(extent.minCoeff() < 1e-9);
    RC_ASSERT(std::abs(extent.maxCoeff() - 4 * std::round(extent.maxCoeff() / 4)) < 1e-6);
  }
}

RC_GTEST_PROP(PlanTracing, TracingADrawnTraceChangesNothing, ()) {
  const FloorPlan plan = turned_room(200, 150, 60, *rc::gen::inRange(-45, 45) * kDegree);
  const auto once = traced(plan);
  const auto twice = traced(drawn_plan(once, plan));
  RC_ASSERT(once.size() == twice.size());
  for (const Segment2& wall : twice) {
    const bool is_there = std::any_of(once.begin(), once.end(), [&](const Segment2& other) {
      return (wall.start - other.start).norm() < 2 * plan.cell_m &&
             (wall.end - other.end).norm() < 2 * plan.cell_m;
    });
    RC_ASSERT(is_there);
  }
}

TEST(PlanTracing, AThinWallHasTwoFacesAndTwoEnds) {
  FloorPlan plan = room(2, 2, 60, 40);
  fill(plan, 10, 20, 50, 21, 1);
  const auto walls = traced(plan);
  EXPECT_EQ(walls.size(), 8);
  EXPECT_EQ(agreement(plan, walls).all, 1);
}

TEST(PlanTracing, ASingleCellKeepsItsForm) {
  const FloorPlan plan = room(1, 1, 1, 1);
  const auto walls = traced(plan);
  ASSERT_EQ(walls.size(), 4);
  for (const Segment2& wall : walls) EXPECT_NEAR(wall.length(), plan.cell_m, 1e-9);
  EXPECT_EQ(agreement(plan, walls).all, 1);
}

TEST(PlanTracing, ADoubleWallStaysDouble) {
  FloorPlan plan = room(2, 2, 60, 40);
  fill(plan, 2, 20, 62, 21, 1);
  fill(plan, 2, 24, 62, 25, 1);
  clean_plan(plan, {.speck_m = 0.1});
  const auto walls = traced(plan);
  EXPECT_EQ(walls.size(), 12) << "two rooms and the space between the lines";
  EXPECT_EQ(agreement(plan, walls).all, 1);
}

TEST(PlanTracing, ANearlyAlignedWallIsSnappedWhereThatStaysWithinTolerance) {
  FloorPlan plan = room(2, 2, 200, 40);
  fill(plan, 100, 41, 202, 42, 1);  // the upper wall is one cell lower in its right half
  const auto walls = traced(plan);
  ASSERT_EQ(walls.size(), 4);
  for (const Segment2& wall : walls) EXPECT_LT((wall.end - wall.start).cwiseAbs().minCoeff(), 1e-9);
}

TEST(PlanTracing, AStepLargerThanTheToleranceStays) {
  FloorPlan plan = room(2, 2, 200, 40);
  fill(plan, 100, 39, 202, 42, 1);
  EXPECT_EQ(traced(plan).size(), 6);
  EXPECT_EQ(agreement(plan, traced(plan)).all, 1);
}

RC_GTEST_PROP(PlanTracing, NoiseIsTracedWithoutHolesOrStraySides, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  FloorPlan plan(60, 40, 1);
  const double share = random.uniform(0.1, 0.9);
  for (int y = 0; y < plan.height; y += 4) {
    for (int x = 0; x < plan.width; x += 4) fill(plan, x, y, x + 4, y + 4, random.uniform() < share);
  }
  const auto walls = traced(plan);
  RC_ASSERT(agreement(plan, walls).away_from_borders == 1);
  for (const Segment2& wall : walls) RC_ASSERT(wall.length() > 0);
}

TEST(PlanCleaning, SpecksGoAndSmallPiecesOfFurnitureStay) {
  FloorPlan plan = room(2, 2, 30, 30);
  fill(plan, 10, 10, 12, 12, 1);
  fill(plan, 20, 20, 23, 22, 1);
  clean_plan(plan, {.speck_m = 0.1});
  EXPECT_FALSE(plan.is_solid(10, 10));
  EXPECT_TRUE(plan.is_solid(20, 20));
}

TEST(PlanCleaning, APillarOfOneCellStaysUnlessSpecksAreRemoved) {
  FloorPlan plan = room(2, 2, 30, 30);
  fill(plan, 10, 10, 11, 11, 1);
  EXPECT_EQ(clean_plan(plan, {}), 0);
  EXPECT_TRUE(plan.is_solid(10, 10));
  EXPECT_EQ(clean_plan(plan, {.speck_m = 0.05}), 1);
  EXPECT_FALSE(plan.is_solid(10, 10));
}

TEST(PlanCleaning, SlitsBetweenTheLinesOfADoubleWallGo) {
  FloorPlan plan = room(2, 2, 30, 30);
  fill(plan, 2, 10, 32, 16, 1);
  fill(plan, 5, 12, 30, 14, 0);
  clean_plan(plan, {.speck_m = 0.1});
  EXPECT_TRUE(plan.is_solid(10, 13));
}

TEST(PlanCleaning, TheOutsideGoesAndTheBuildingStays) {
  FloorPlan plan(60, 60, 0);
  fill(plan, 20, 20, 40, 40, 1);
  fill(plan, 22, 22, 38, 38, 0);
  clean_plan(plan, {.speck_m = 0.1});
  EXPECT_TRUE(plan.is_solid(5, 5));
  EXPECT_FALSE(plan.is_solid(30, 30));
}

TEST(PlanCleaning, ACorridorThatIsCutOffByThePlansBorderStays) {
  FloorPlan plan(60, 60, 1);
  fill(plan, 0, 20, 60, 35, 0);
  fill(plan, 10, 40, 30, 55, 0);
  clean_plan(plan, {.speck_m = 0.1});
  EXPECT_FALSE(plan.is_solid(0, 25));
  EXPECT_EQ(traced(plan).size(), 8);
}

TEST(PlanTracing, BordersThatNoWorldHoldsAreNotTraced) {
  FloorPlan chequered(1100, 1000, 1);
  for (int y = 0; y < chequered.height; ++y) {
    for (int x = y % 2; x < chequered.width; x += 2) chequered.solid[chequered.index(x, y)] = 0;
  }
  SilentProgress silent;
  EXPECT_FALSE(trace_plan(chequered, {}, silent).has_value());
}

}  // namespace
}  // namespace aisle
