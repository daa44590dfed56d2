#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "aisle/formats/worlds/scenario_yaml.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr const char* kScenarioHead = "format: aisle.scenario\nversion: 1\n";

std::string scenario_problems(const std::string& events) {
  const auto scenario = parse_scenario(kScenarioHead + events, "bad.yaml");
  return scenario.ok() ? "" : to_string(scenario.problems());
}

TEST(ScenarioYaml, EveryFaultIsReadWithItsTimesAndPlaces) {
  const auto good = parse_scenario(std::string(kScenarioHead) + R"(name: all
world: attic
events:
  - {from_s: 3, for_s: 2, camera: {fault: late, name: front, delay_s: 0.7}}
  - {near: [4, 5], radius_m: 0.4, slip: {spin: 2}}
  - steering: {bias_deg: -9}
  - box: {centre: [1, 2], size: [3, 4], heading_deg: 90, height_m: 0.6}
  - person: {path: [[1, 2], [3, 4]], speed_mps: 2}
  - lift: {at: [7, 8], heading_deg: 180}
  - laser_off: {}
  - light: {light: 0.1, lamps: off}
)",
                                   "all.yaml");
  ASSERT_TRUE(good.ok()) << to_string(good.problems());
  EXPECT_EQ(good->world, "attic");
  const auto& events = good->events;
  ASSERT_THAT(events, SizeIs(8));
  const auto camera = std::get<CameraFault>(events[0].fault);
  EXPECT_EQ(camera.kind, CameraFault::Kind::kLate);
  EXPECT_EQ(camera.camera, "front");
  EXPECT_EQ(camera.delay_s, 0.7);
  EXPECT_EQ(events[0].from_s, 3);
  EXPECT_EQ(events[0].duration_s, 2);
  EXPECT_FALSE(events[0].near);
  EXPECT_EQ(std::get<SlipBurst>(events[1].fault).spin, 2);
  EXPECT_EQ(*events[1].near, Vec2(4, 5));
  EXPECT_EQ(events[1].radius_m, 0.4);
  EXPECT_TRUE(std::isinf(events[1].duration_s));
  EXPECT_DOUBLE_EQ(std::get<SteeringBias>(events[2].fault).bias_rad, -9 * kDegree);
  EXPECT_EQ(std::get<BlockingBox>(events[3].fault).size, Vec2(3, 4));
  EXPECT_THAT(std::get<CrossingPerson>(events[4].fault).person.path, SizeIs(2));
  EXPECT_DOUBLE_EQ(std::get<Lifted>(events[5].fault).T_world_vehicle.theta, kPi);
  EXPECT_TRUE(std::holds_alternative<LaserOff>(events[6].fault));
  EXPECT_FALSE(std::get<LightChange>(events[7].fault).lamps_on);
}

TEST(ScenarioYaml, EveryProblemIsNamedWithItsPlace) {
  EXPECT_THAT(scenario_problems("events:\n  - {from_s: -1, slip: {}}\n"),
              HasSubstr("bad.yaml:4: events[0].from_s:"));
  EXPECT_THAT(scenario_problems("events:\n  - {from_s: 1}\n"),
              HasSubstr("bad.yaml:4: events[0]: needs one fault"));
  EXPECT_THAT(scenario_problems("events:\n  - {slip: {}, laser_off: {}}\n"), HasSubstr("needs one fault"));
  EXPECT_THAT(scenario_problems("events:\n  - {camera: {fault: broken}}\n"),
              HasSubstr("events[0].camera.fault"));
  EXPECT_THAT(scenario_problems("events:\n  - {person: {path: [[0, 0]]}}\n"), HasSubstr("two points"));
  EXPECT_THAT(scenario_problems("events:\n  - {flood: {}}\n"), HasSubstr("flood"));
  EXPECT_THAT(scenario_problems("events: 3\n"), HasSubstr("events"));
  EXPECT_THAT(to_string(parse_scenario("- 1", "a").problems()), HasSubstr("is not a scenario"));
  EXPECT_THAT(to_string(parse_scenario("a: [", "a").problems()), HasSubstr("is not YAML"));
}

TEST(ScenarioYaml, EveryShippedScenarioIsRead) {
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(AISLE_SOURCE_DIR "/scenarios")) {
    const auto scenario = read_scenario(entry.path());
    ASSERT_TRUE(scenario.ok()) << to_string(scenario.problems());
    EXPECT_THAT(scenario->events, Not(IsEmpty())) << entry.path();
    EXPECT_EQ(scenario->name + ".yaml", entry.path().filename());
    const auto needs_a_place = [](const ScenarioEvent& event) {
      return event.near || std::holds_alternative<BlockingBox>(event.fault) ||
             std::holds_alternative<CrossingPerson>(event.fault) ||
             std::holds_alternative<Lifted>(event.fault);
    };
    EXPECT_EQ(!scenario->world.empty(),
              std::any_of(scenario->events.begin(), scenario->events.end(), needs_a_place))
        << entry.path() << ": a scenario with places belongs to a world";
    ++read;
  }
  EXPECT_GE(read, 11U);
}

}  // namespace
}  // namespace aisle
