#include "live_events.hpp"

#include <gmock/gmock.h>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/decision_text.hpp"

namespace aisle {
namespace {

constexpr ros::Stamp_ns kSecond = 1'000'000'000;

class Events : public testing::Test {
 protected:
  void decide(ros::Stamp_ns stamp, const std::string& state, const std::string& why = "") {
    text("/decision", stamp, decision_text({.command = {}, .state = state, .why = why}));
  }
  void text(const char* topic, ros::Stamp_ns stamp, const std::string& data) {
    events.take({topic, ros::String::kType}, stamp, cdr_bytes(ros::String{data}), p_map);
  }
  void touch(ros::Stamp_ns stamp, bool is_pressed) {
    events.take({"/bumper", ros::Bool::kType}, stamp, cdr_bytes(ros::Bool{is_pressed}), p_map);
  }
  std::string told(std::size_t from = 0) const { return events.json(from).dump(); }

  LiveEvents events;
  std::optional<Vec2> p_map;
};

TEST_F(Events, AreNewStatesWhereTheVehicleIs) {
  decide(0, "looking");
  decide(kSecond, "looking", "still");
  p_map = Vec2(1.204, -2);
  decide(2 * kSecond, "lost", "no walls fit");
  EXPECT_EQ(told(), R"({"from":0,"events":[{"stamp_s":0.0,"kind":"state","text":"looking"},)"
                    R"({"stamp_s":2.0,"kind":"state","text":"lost: no walls fit","at_m":[1.2,-2.0]}]})");
}

TEST_F(Events, AreMarksAndTheBeginningsOfContacts) {
  text("/operator", 0,
       operator_text({.requested = {}, .marks = {{Mark::Kind::kPlace, "desk"}, {Mark::Kind::kStop, ""}}}));
  for (const bool is_pressed : {false, true, true, false, true}) touch(kSecond, is_pressed);
  EXPECT_EQ(events.count(), 4);
  const auto json = events.json(0)["events"];
  EXPECT_EQ(json[0]["text"], "place desk");
  EXPECT_EQ(json[1]["text"], "stop");
  EXPECT_EQ(json[3]["kind"], "contact");
}

TEST_F(Events, AreWhatBecomesOfTheGoals) {
  p_map = Vec2(1, 2);
  text("/goals", 0, R"({"goals":[{"place":"desk"},{"x_m":8,"y_m":2}],"reached":0})");
  events.take_goals(kSecond, R"({"goals":[{"place":"desk"}],"reached":0})", p_map);
  text("/goals", 2 * kSecond, R"({"goals":[{"place":"desk"}],"reached":0})");
  text("/goals", 3 * kSecond, R"({"goals":[{"place":"desk"}],"reached":1})");
  EXPECT_EQ(
      told(),
      R"json({"from":0,"events":[{"stamp_s":0.0,"kind":"goal_next","text":"desk (1/2)","at_m":[1.0,2.0]},)json"
      R"json({"stamp_s":1.0,"kind":"goal_removed","text":"8.00, 2.00 m","at_m":[1.0,2.0]},)json"
      R"json({"stamp_s":3.0,"kind":"goal_reached","text":"desk","at_m":[1.0,2.0]}]})json");
}

TEST_F(Events, AreToldFromWhereAClientHasThem) {
  for (const char* state : {"a", "b", "c"}) decide(0, state);
  EXPECT_EQ(told(2), R"({"from":2,"events":[{"stamp_s":0.0,"kind":"state","text":"c"}]})");
  EXPECT_EQ(told(9), R"({"from":3,"events":[]})");
}

TEST_F(Events, AreBoundedAndSayWhatIsGone) {
  const std::string longer(LiveEvents::kTextMax + 9, 'x');
  for (std::size_t i = 0; i < LiveEvents::kEventsMax + 5; ++i) decide(0, std::to_string(i) + longer);
  EXPECT_EQ(events.count(), LiveEvents::kEventsMax + 5);
  const auto json = events.json(0);
  EXPECT_EQ(json["from"], 5);
  EXPECT_EQ(json["events"].size(), LiveEvents::kEventsMax);
  EXPECT_EQ(json["events"][0]["text"].get<std::string>().size(), LiveEvents::kTextMax);
}

TEST_F(Events, OfANewMissionAreNone) {
  decide(0, "looking");
  events.begin();
  EXPECT_EQ(events.count(), 0);
  decide(0, "looking");
  EXPECT_EQ(events.count(), 1);
}

TEST_F(Events, OfASessionAreToldFromItsBeginning) {
  events.begin(1'700'000'000 * kSecond);
  decide(1'700'000'003 * kSecond, "looking");
  EXPECT_EQ(events.json(0)["events"][0]["stamp_s"], 3.0);
}

TEST_F(Events, IgnoreWhatCannotBeRead) {
  for (const char* topic : {"/decision", "/operator", "/bumper", "/goals"})
    events.take({topic, ros::String::kType}, 0, "damaged", {});
  for (const char* topic : {"/decision", "/goals"}) text(topic, 0, "{}");
  EXPECT_EQ(events.count(), 0);
}

}  // namespace
}  // namespace aisle
