#include <gtest/gtest.h>

#include "aisle/exploration/corridor_rules.hpp"

namespace aisle {
namespace {

constexpr auto kForward = static_cast<Symbol>(CorridorOutput::kForward);
constexpr auto kForwardLeft = static_cast<Symbol>(CorridorOutput::kForwardLeft);
constexpr auto kBackward = static_cast<Symbol>(CorridorOutput::kBackward);
constexpr auto kStop = static_cast<Symbol>(CorridorOutput::kStop);

TEST(CorridorRules, OneCorridorIsDrivenToItsEndAndBack) {
  TransducerRun run(corridor_rules());
  EXPECT_EQ(run.step(corridor_input::one_direction(Bearing::kForward)).output, kForward);
  run.step(corridor_input::kEnd);
  EXPECT_EQ(run.state(), static_cast<Symbol>(CorridorState::kRetreating));
  EXPECT_EQ(run.step(corridor_input::kAway).output, kBackward);
  EXPECT_EQ(run.step(corridor_input::kExplored).output, kStop);
  EXPECT_TRUE(run.halted());
}

TEST(CorridorRules, PublishedCrossingIsLeftByThePathBackLast) {
  TransducerRun run(corridor_rules());
  run.step(corridor_input::kCrossingPathBack);
  run.step(corridor_input::crossing(Bearing::kLeft));
  EXPECT_EQ(run.step(corridor_input::one_direction(Bearing::kForward)).output, kForward);
  run.step(corridor_input::kEnd);
  EXPECT_EQ(run.step(corridor_input::kExplored).output, kForwardLeft);
  run.step(corridor_input::kEnd);
  EXPECT_EQ(run.step(corridor_input::kExplored).output, kBackward);
  EXPECT_EQ(run.top(), kCorridorStackStart);
}

TEST(CorridorRules, PathTakenBeforeItsTurnIsDroppedWhenItComesUp) {
  TransducerRun run(corridor_rules());
  run.step(corridor_input::crossing(Bearing::kLeft));
  run.step(corridor_input::crossing(Bearing::kRight));
  run.step(corridor_input::kEnd);
  EXPECT_EQ(run.step(corridor_input::detour(Bearing::kLeft)).output, kForwardLeft);
  run.step(corridor_input::kEnd);
  run.step(corridor_input::kExplored);
  run.step(corridor_input::kEnd);
  EXPECT_EQ(run.top(), explore_symbol(Bearing::kLeft));
  run.step(corridor_input::kClosed);
  EXPECT_EQ(run.top(), kCorridorStackStart);
}

TEST(CorridorRules, NeverStopWhileSomethingWaits) {
  const TransducerTable& table = corridor_rules();
  for (Symbol top = explore_symbol(Bearing::kForward); top < table.empty_stack(); ++top) {
    for (std::size_t input = 0; input < table.inputs.size(); ++input) {
      for (const CorridorState state : {CorridorState::kExploring, CorridorState::kRetreating}) {
        const TransducerRule& rule = table.rule(static_cast<Symbol>(state), static_cast<Symbol>(input), top);
        EXPECT_FALSE(rule.defined() && rule.output == kStop);
      }
    }
  }
}

}  // namespace
}  // namespace aisle
