#include "aisle/exploration/pushdown_transducer.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

enum State : Symbol { kReading, kDone };
enum Input : Symbol { kOpen, kClose, kEnd };
enum Stack : Symbol { kBottom, kBracket };

/// Accepts matching brackets, and answers each closing one.
TransducerTable brackets() {
  TransducerTable table;
  table.states = {"reading", "done"};
  table.inputs = {"open", "close", "end"};
  table.stack = {"bottom", "bracket"};
  table.outputs = {"matched", "accepted"};
  table.super_rules = {"only"};
  table.start_state = kReading;
  table.final_state = kDone;
  table.start_symbol = kBottom;
  table.rules.resize(table.transition_rules());
  const auto rule = [&](Input input, Stack top) -> TransducerRule& {
    return table.rules[table.place(kReading, input, top)];
  };
  rule(kOpen, kBottom) = {kReading, TransducerRule::kNoOutput, 0, true, 2, {kBottom, kBracket}};
  rule(kOpen, kBracket) = {kReading, TransducerRule::kNoOutput, 0, true, 2, {kBracket, kBracket}};
  rule(kClose, kBracket) = {kReading, 0, 0, true, 0, {}};
  rule(kEnd, kBottom) = {kDone, 1, 0, true, 0, {}};
  return table;
}

TEST(PushdownTransducer, PushesPopsAndHalts) {
  const TransducerTable table = brackets();
  TransducerRun run(table);
  run.step(kOpen);
  run.step(kOpen);
  EXPECT_THAT(run.stack(), ElementsAre(kBottom, kBracket, kBracket));
  EXPECT_EQ(run.step(kClose).output, 0);
  run.step(kClose);
  EXPECT_FALSE(run.halted());
  EXPECT_EQ(run.step(kEnd).output, 1);
  EXPECT_TRUE(run.halted());
  EXPECT_THAT(run.stack(), IsEmpty());
  EXPECT_EQ(run.top(), table.empty_stack());
}

TEST(PushdownTransducer, NamesACombinationWithoutARuleAndKeepsItsState) {
  const TransducerTable table = brackets();
  TransducerRun run(table);
  try {
    run.step(kClose);
    FAIL() << "a bracket was closed that was not open";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "no rule for state reading, input close, top bottom");
  }
  EXPECT_EQ(run.state(), kReading);
  EXPECT_THAT(run.stack(), ElementsAre(kBottom));
}

TEST(PushdownTransducer, CountsItsRulesAsThePaperDoes) {
  EXPECT_EQ(brackets().transition_rules(), 2U * 3U * 3U);
  EXPECT_EQ(brackets().output_rules(), 1U * 3U * 2U);
}

}  // namespace
}  // namespace aisle
