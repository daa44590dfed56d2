#include "goal_events.hpp"

#include <gmock/gmock.h>

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "kind: text" of each.
std::vector<std::string> between(const MissionGoals& before, const MissionGoals& now) {
  std::vector<std::string> texts;
  for (const GoalEvent& event : goal_events(before, now))
    texts.push_back(std::string(event.kind) + ": " + event.text);
  return texts;
}

TEST(GoalEvents, AMissionBeginsWithItsNextGoal) {
  EXPECT_THAT(between({}, {{"a", "b"}, 0}), ElementsAre("goal_next: a (1/2)"));
  EXPECT_THAT(between({}, {{"desk"}, 0}), ElementsAre("goal_next: desk"));
  EXPECT_THAT(between({}, {}), IsEmpty()) << "a patrol";
}

TEST(GoalEvents, AGoalIsReachedAndTheNextOneFollows) {
  EXPECT_THAT(between({{"a", "b"}, 0}, {{"a", "b"}, 1}),
              ElementsAre("goal_reached: a (1/2)", "goal_next: b (2/2)"));
  EXPECT_THAT(between({{"a", "b"}, 1}, {{"a", "b"}, 2}), ElementsAre("goal_reached: b (2/2)"));
  EXPECT_THAT(between({{"a", "b"}, 1}, {{"a", "b"}, 1}), IsEmpty());
}

TEST(GoalEvents, WhatIsAddedAndRemovedIsTold) {
  EXPECT_THAT(between({{"a", "b"}, 0}, {{"a", "b", "c"}, 0}), ElementsAre("goal_added: c"));
  EXPECT_THAT(between({{"a", "b", "c"}, 0}, {{"a", "c"}, 0}), ElementsAre("goal_removed: b"));
  EXPECT_THAT(between({{"a", "a", "b"}, 1}, {{"a", "b", "c"}, 1}),
              ElementsAre("goal_removed: a", "goal_added: c", "goal_next: b (2/3)"))
      << "the first a is reached, the second one was the next";
}

TEST(GoalEvents, AfterTheLastGoalAnotherMayBeAdded) {
  EXPECT_THAT(between({{"a"}, 1}, {{"a", "b"}, 1}), ElementsAre("goal_added: b", "goal_next: b (2/2)"));
}

TEST(GoalEvents, GoalsAreNamedByPlaceOrPosition) {
  const auto goals = parse_goals(
      R"({"goals":[{"place":"Büro"},{"x_m":1,"y_m":-2.3},{"x_m":0,"y_m":-0.001,"heading_deg":90.4}],"reached":1})");
  ASSERT_TRUE(goals);
  EXPECT_THAT(goals->names, ElementsAre("Büro", "1.00, -2.30 m", "0.00, 0.00 m, 90°"));
  EXPECT_EQ(goals->reached, 1U);
}

TEST(GoalEvents, WhatIsNoMessageAboutGoalsIsIgnored) {
  for (const char* text : {"", "{}", R"({"goals":[1],"reached":0})", R"({"goals":[{"x_m":"a"}],"reached":0})",
                           R"({"goals":[],"reached":"all"})"})
    EXPECT_FALSE(parse_goals(text)) << text;
  EXPECT_EQ(parse_goals(R"({"goals":[{"place":"a"}],"reached":9})")->reached, 1U);
}

}  // namespace
}  // namespace aisle
