#include "aisle/exploration/grid_rules.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "aisle/exploration/grid_explorer.hpp"
#include "worlds.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const GridRules& published() {
  return grid_rules(GridRuleSet::kPublished);
}

/// "q_r E_t E_r R_b E_b / O_l": next state, what replaces the top (new top first, as C97 writes it), output.
std::string rule_text(const GridRules& rules, GridState state, int g, const std::string& top) {
  const TransducerTable& table = rules.table;
  const auto at =
      static_cast<Symbol>(std::find(table.stack.begin(), table.stack.end(), top) - table.stack.begin());
  const TransducerRule& rule = table.rule(static_cast<Symbol>(state), static_cast<Symbol>(g - 1), at);
  if (!rule.defined()) return "none";
  std::string text = table.states[rule.next_state];
  for (int i = rule.length - 1; i >= 0; --i)
    text += " " + table.stack[rule.replacement[static_cast<std::size_t>(i)]];
  return text + " / " + (rule.output == TransducerRule::kNoOutput ? "-" : table.outputs[rule.output]);
}

TEST(GridRules, HaveTheCountsOfThePaper) {
  const TransducerTable& table = published().table;
  EXPECT_EQ(table.inputs.size(), 52U);
  EXPECT_EQ(table.stack.size(), 9U);
  EXPECT_EQ(table.states.size(), 3U);
  EXPECT_EQ(table.outputs.size(), 5U);
  EXPECT_EQ(table.transition_rules(), 1560U);
  EXPECT_EQ(table.output_rules(), 936U);
}

TEST(GridRules, NumberTheInputsAsThePaperDoes) {
  const std::vector<GridInput>& inputs = published().inputs;
  const auto kind = [&](int g) { return inputs[static_cast<std::size_t>(g - 1)].kind; };
  for (const auto& [first, last, of] :
       {std::tuple{1, 12, GridInputKind::kOneDirection}, std::tuple{13, 28, GridInputKind::kCrossing},
        std::tuple{29, 32, GridInputKind::kEnding}, std::tuple{33, 36, GridInputKind::kExplored},
        std::tuple{37, 40, GridInputKind::kOneDirectionStart},
        std::tuple{41, 51, GridInputKind::kMultiPathStart}, std::tuple{52, 52, GridInputKind::kDeadStart}}) {
    for (int g = first; g <= last; ++g) EXPECT_EQ(kind(g), of) << "G" << g;
  }
}

TEST(GridRules, ContainTheExamplesOfThePaper) {
  EXPECT_EQ(rule_text(published(), GridState::kRetreating, 1, "E_b"), "q_r E_b / O_r");
  EXPECT_EQ(rule_text(published(), GridState::kExploring, 29, "E_b"), "q_r E_b / O_l");
  EXPECT_EQ(rule_text(published(), GridState::kRetreating, 29, "Z_0"), "q_fin Z_0 / O_s");
  EXPECT_EQ(rule_text(published(), GridState::kExploring, 52, "Z_0"), "q_fin Z_0 / O_s");
  EXPECT_EQ(rule_text(published(), GridState::kExploring, 24, "E_b"), "q_e E_t E_r R_b E_b / O_l");
  EXPECT_EQ(rule_text(published(), GridState::kExploring, 33, "E_b"), "q_r E_b / O_l");
  EXPECT_EQ(rule_text(published(), GridState::kRetreating, 33, "Z_0"), "q_fin Z_0 / O_s");
  EXPECT_EQ(rule_text(published(), GridState::kRetreating, 33, "E_b"), "q_e / O_b");
  EXPECT_EQ(rule_text(published(), GridState::kRetreating, 33, "R_b"), "q_r / O_b");
}

TEST(GridRules, HaveNoneForWhatThePaperCallsImpossible) {
  EXPECT_EQ(rule_text(published(), GridState::kRetreating, 24, "E_b"), "none");
  EXPECT_EQ(rule_text(published(), GridState::kRetreating, 29, "E_b"), "none");
  EXPECT_EQ(rule_text(published(), GridState::kFinal, 1, "Z_0"), "none");
}

TEST(GridRules, DropAPathBehindAFalseWallWithoutAMove) {
  const GridRules& rules = grid_rules(GridRuleSet::kShortcut);
  const Symbol input = rules.explored_input[static_cast<std::size_t>(Side::kLeft)][bit(Side::kBottom)];
  EXPECT_EQ(rule_text(rules, GridState::kRetreating, input + 1, "E_b"), "q_r / -");
  EXPECT_EQ(rule_text(rules, GridState::kRetreating, input + 1, "E_t"), "q_e / O_t");
}

TEST(GridRules, AreFoundByName) {
  for (const GridRuleSet set : kGridRuleSets) EXPECT_EQ(grid_rule_set(name_of(set)), set);
  EXPECT_EQ(grid_rule_set("quickest"), std::nullopt);
}

class RulesThatFire : public testing::TestWithParam<GridRuleSet> {
 protected:
  void run(const GridWorld& world) {
    GridExplorer explorer(rules_, world.width(), world.height(), world.start,
                          [this](const TransducerRule& rule) {
                            fired_[static_cast<std::size_t>(&rule - rules_.table.rules.data())] = true;
                          });
    while (explorer.step(world.open(explorer.at_index()))) {
    }
  }

  std::vector<std::string> rules_where(bool fired, bool marked) const {
    const TransducerTable& table = rules_.table;
    std::vector<std::string> found;
    for (std::size_t i = 0; i < table.rules.size(); ++i) {
      if (fired_[i] != fired || table.rules[i].reachable != marked) continue;
      const std::size_t top = i % table.tops();
      const std::size_t input = i / table.tops() % table.inputs.size();
      const std::size_t state = i / table.tops() / table.inputs.size();
      found.push_back(table.states[state] + " " + table.inputs[input] + " " +
                      (top == table.stack.size() ? "empty" : table.stack[top]));
    }
    return found;
  }

  const GridRules& rules_ = grid_rules(GetParam());
  std::vector<bool> fired_ = std::vector<bool>(rules_.table.rules.size(), false);
};

INSTANTIATE_TEST_SUITE_P(Rules, RulesThatFire, testing::ValuesIn(kGridRuleSets),
                         [](const auto& rules) { return std::string(name_of(rules.param)); });

TEST_P(RulesThatFire, AreExactlyThoseMarkedAsReachable) {
  Random random(5);
  for (int i = 0; i < 60000; ++i) {
    GridWorld world(static_cast<int>(1 + random.index(9)), static_cast<int>(1 + random.index(9)));
    const double open_share = random.uniform(0.4, 0.9);
    for (std::size_t cell = 0; cell < world.size(); ++cell) {
      const Cell at = world.cell(cell);
      if (at.x + 1 < world.width()) world.set_open(at, Side::kRight, random.uniform() < open_share);
      if (at.y + 1 < world.height()) world.set_open(at, Side::kTop, random.uniform() < open_share);
    }
    world.start = world.cell(random.index(world.size()));
    run(world);
  }
  EXPECT_THAT(rules_where(true, false), IsEmpty()) << "marked as unreachable, but it fired";
  EXPECT_THAT(rules_where(false, true), IsEmpty()) << "marked as reachable, but never fired";
}

}  // namespace
}  // namespace aisle
