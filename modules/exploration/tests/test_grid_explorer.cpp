#include "aisle/exploration/grid_explorer.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/exploration/exploration_run.hpp"
#include "aisle/exploration/walk_bound.hpp"
#include "worlds.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Exploration explored(const GridWorld& world, GridRuleSet set) {
  SilentProgress progress;
  return explore(world, world.start, grid_rules(set), progress, KeepMoves::kYes);
}

/// What the rules promise beyond complete exploration.
bool keeps_bound(GridRuleSet set, const ExplorationFigures& figures) {
  switch (set) {
    case GridRuleSet::kPublished:
      return figures.max_edge_uses <= 4;
    case GridRuleSet::kShortcut:
      return figures.max_edge_uses <= 2;
    case GridRuleSet::kCells:
      return figures.max_edge_uses <= 2 && figures.moves == figures.tree_moves();
    case GridRuleSet::kHoming:
      return figures.moves <= figures.tree_moves();
    case GridRuleSet::kRoaming:
      return true;
  }
  return false;
}

class EveryRuleSet : public testing::TestWithParam<GridRuleSet> {};

INSTANTIATE_TEST_SUITE_P(Rules, EveryRuleSet, testing::ValuesIn(kGridRuleSets),
                         [](const auto& rules) { return std::string(name_of(rules.param)); });

TEST_P(EveryRuleSet, StopsAtOnceWhereThereIsNoPathOut) {
  const Exploration run = explored(GridWorld(1, 1), GetParam());
  EXPECT_THAT(run.moves, IsEmpty());
  EXPECT_TRUE(run.figures.complete());
}

TEST_P(EveryRuleSet, WalksACorridorToItsEndAndBack) {
  const Exploration run = explored(world_of({{"r", "lr", "l"}}), GetParam());
  EXPECT_THAT(run.moves, ElementsAre(Side::kRight, Side::kRight, Side::kLeft, Side::kLeft));
  EXPECT_TRUE(run.figures.complete());
  EXPECT_EQ(run.figures.max_stack, 0U);
}

TEST_P(EveryRuleSet, ExploresEveryWorldOfUpToFourByThreeCellsFromEveryStart) {
  SilentProgress progress;
  const GridRules& rules = grid_rules(GetParam());
  for (int width = 1; width <= 4; ++width) {
    for (int height = 1; height <= 3; ++height) {
      for (std::uint64_t bits = 0; bits < std::uint64_t{1} << inner_edges(width, height); ++bits) {
        const GridWorld world = world_from_bits(width, height, bits);
        for (std::size_t start = 0; start < world.size(); ++start) {
          const ExplorationFigures figures = explore(world, world.cell(start), rules, progress).figures;
          ASSERT_TRUE(figures.complete() && keeps_bound(GetParam(), figures))
              << width << " x " << height << ", edges " << bits << ", start " << start;
        }
      }
    }
  }
}

TEST_P(EveryRuleSet, ExploresEveryRandomWorld) {
  const GridRuleSet set = GetParam();
  EXPECT_TRUE(rc::check("complete, and within its bound", [set] {
    for (int i = 0; i < 30; ++i) {
      const GridWorld world = random_world(60);
      const ExplorationFigures figures = explored(world, set).figures;
      RC_ASSERT(figures.complete());
      RC_ASSERT(keeps_bound(set, figures));
      RC_ASSERT(figures.moves >= walk_lower_bound(world, world.start));
    }
  }));
}

TEST(Shortcut, WalksARingOnceOutAndOnceBack) {
  const GridWorld ring = world_of({{"rb", "lb"}, {"rt", "lt"}});
  EXPECT_EQ(explored(ring, GridRuleSet::kPublished).figures.moves, 16U);
  EXPECT_EQ(explored(ring, GridRuleSet::kShortcut).figures.moves, 8U);
  EXPECT_EQ(explored(ring, GridRuleSet::kCells).figures.moves, 6U);
  EXPECT_EQ(explored(ring, GridRuleSet::kHoming).figures.moves, 4U);
  EXPECT_EQ(explored(ring, GridRuleSet::kRoaming).figures.moves, 4U);
}

}  // namespace
}  // namespace aisle
