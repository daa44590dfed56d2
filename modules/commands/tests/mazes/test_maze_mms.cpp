#include "aisle/commands/mazes/maze_mms.hpp"

#include <gmock/gmock.h>
#include <ext/stdio_filebuf.h>

#include <istream>
#include <ostream>

#include "aisle/exploration/maze_generator.hpp"
#include "maze_mms_stand_in.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

Result<Outcome> run_mouse(MmsStandIn& simulator, GridRuleSet rules = GridRuleSet::kHoming) {
  __gnu_cxx::stdio_filebuf<char> replies_buffer(dup(simulator.replies_fd()), std::ios::in);
  __gnu_cxx::stdio_filebuf<char> commands_buffer(dup(simulator.commands_fd()), std::ios::out);
  std::istream replies(&replies_buffer);
  std::ostream commands(&commands_buffer);
  SilentProgress progress;
  Console console{progress, [](const std::string&) {}};
  simulator.start();
  auto outcome = run_maze_mms({rules, &replies, &commands}, console);
  commands_buffer.close();
  simulator.finish();
  return outcome;
}

GridWorld maze(std::uint64_t seed) {
  return generate_maze({.kind = MazeKind::kBraided, .width = 9, .height = 7}, Random(seed));
}

class Mouse : public testing::TestWithParam<GridRuleSet> {};

INSTANTIATE_TEST_SUITE_P(Rules, Mouse, testing::ValuesIn(kGridRuleSets),
                         [](const auto& rules) { return std::string(name_of(rules.param)); });

TEST_P(Mouse, ExploresAllAndDrivesToTheMiddleWithoutAnIllegalCommand) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    MmsStandIn simulator(maze(seed));
    const auto outcome = run_mouse(simulator, GetParam());
    ASSERT_TRUE(outcome.ok()) << to_string(outcome.problems());
    EXPECT_TRUE(outcome->ok);
    EXPECT_EQ(simulator.illegal, "");
    EXPECT_EQ(simulator.crashes, 0);
    EXPECT_THAT(simulator.visited, SizeIs(63));
    EXPECT_EQ(simulator.at, (Cell{4, 3}));
  }
}

TEST(Mouse, StartsAgainWhenTheResetButtonIsPressed) {
  MmsStandIn undisturbed(maze(2));
  ASSERT_TRUE(run_mouse(undisturbed).ok());
  for (const int moves : {1, 40, undisturbed.moves - 1, undisturbed.moves}) {
    MmsStandIn simulator(maze(2));
    simulator.press_reset_after(moves);
    const auto outcome = run_mouse(simulator);
    ASSERT_TRUE(outcome.ok() && outcome->ok);
    EXPECT_EQ(simulator.illegal, "");
    EXPECT_EQ(simulator.resets, 1) << moves;
    EXPECT_THAT(simulator.visited, SizeIs(63));
    EXPECT_EQ(simulator.at, (Cell{4, 3}));
  }
}

TEST(Mouse, FailsWhereTheMiddleCannotBeReached) {
  GridWorld world(5, 5);
  world.set_open({0, 0}, Side::kTop, true);
  MmsStandIn simulator(world);
  const auto outcome = run_mouse(simulator);
  ASSERT_TRUE(outcome.ok());
  EXPECT_FALSE(outcome->ok);
  EXPECT_EQ(outcome->figures["visited"], 2);
}

TEST(Mouse, FailsWhenItRunsIntoAWall) {
  MmsStandIn simulator(maze(1));
  simulator.answer_moves_with("crash");
  const auto outcome = run_mouse(simulator);
  ASSERT_TRUE(outcome.ok());
  EXPECT_FALSE(outcome->ok);
  EXPECT_EQ(outcome->figures["crashed"], true);
}

TEST(Mouse, ReportsASimulatorThatEndsOrRepliesAgainstTheProtocol) {
  MmsStandIn leaving(maze(1));
  leaving.leave_after(5);
  EXPECT_THAT(to_string(run_mouse(leaving).problems()), HasSubstr("ended before it answered moveForward"));
  MmsStandIn babbling(maze(1));
  babbling.answer_moves_with("perhaps");
  EXPECT_THAT(to_string(run_mouse(babbling).problems()), HasSubstr("'perhaps' is no answer to"));
}

}  // namespace
}  // namespace aisle
