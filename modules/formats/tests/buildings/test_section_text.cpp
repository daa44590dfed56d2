#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/buildings/section_text.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using Kind = Section::Kind;

double millimetres(Random& random, double min_m, double max_m) {
  return std::round(random.uniform(min_m, max_m) * 1000) / 1000;
}

Section any_section(Random& random) {
  const Kind kinds[] = {Kind::kFollow, Kind::kHybrid, Kind::kDead, Kind::kCurve, Kind::kTurn, Kind::kBack};
  Section section{.kind = kinds[random.index(6)]};
  if (section.kind == Kind::kTurn) {
    const int quanta = static_cast<int>(random.index(144)) + 1;
    section.turn_rad = (random.uniform() < 0.5 ? -1 : 1) * quanta * kTurnQuantum_rad;
  } else if (section.kind == Kind::kCurve) {
    section.p_start_end = {millimetres(random, 0.05, 10), millimetres(random, 0.05, 10)};
  } else {
    section.length_m = millimetres(random, 0.001, 1000);
    const bool has_walls = section.kind == Kind::kFollow || section.kind == Kind::kHybrid;
    if (has_walls && random.uniform() < 0.5) section.right_m = millimetres(random, 0.1, 5);
    if (has_walls && random.uniform() < 0.5) section.left_m = millimetres(random, 0.1, 5);
    if (has_walls && random.uniform() < 0.5) section.ahead_m = millimetres(random, 0.1, 5);
  }
  return section;
}

RC_GTEST_PROP(SectionText, IsReadAsItWasWritten, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const Section section = any_section(random);
  const auto read = parse_section(section_text(section));
  RC_ASSERT(read.ok());
  RC_ASSERT(*read == section);
}

TEST(SectionText, SaysWhatALineShouldHaveBeen) {
  for (const char* line : {"",
                           "x 3",
                           "a",
                           "a -1",
                           "a nan",
                           "a 3 right",
                           "a 3 right 0",
                           "a 3 right 1 right 2",
                           "a 3 up 1",
                           "a 3 ahead 0",
                           "a 3 ahead 1 ahead 1",
                           "d 2 ahead 1",
                           "d 2 right 1",
                           "l 0",
                           "l 3.5",
                           "r 145",
                           "l 3 4",
                           "c 1",
                           "c 1 0",
                           "c 1 11",
                           "a 1e99",
                           "b 0"}) {
    EXPECT_FALSE(parse_section(line).ok()) << line;
  }
  EXPECT_THAT(to_string(parse_section("x 3").problems()), HasSubstr("a, h, d, b, c, l, r"));
  EXPECT_THAT(to_string(parse_section("a 3 right 50").problems()), HasSubstr("up to 20"));
}

SectionList list(const std::vector<const char*>& lines) {
  SectionList sections;
  for (const char* line : lines) sections.push_back(*parse_section(line));
  return sections;
}

TEST(SectionText, AnOrderThatCannotBeDrivenIsAFault) {
  EXPECT_THAT(section_faults(list({"a 3", "c 1 1", "h 2", "r 36", "a 1", "l 36", "d 1", "l 36", "a 2"})),
              IsEmpty());
  EXPECT_THAT(section_faults(list({"h 2", "l 36", "a 1"})), SizeIs(1));
  EXPECT_THAT(section_faults(list({"h 2"})), SizeIs(1));
  EXPECT_THAT(section_faults(list({"d 2", "l 36", "a 1"})), SizeIs(1));
  EXPECT_THAT(section_faults(list({"a 1", "l 3", "r 3"})), SizeIs(1));
  EXPECT_THAT(section_faults(list({"l 3"})), SizeIs(1));
  EXPECT_THAT(section_faults({}), SizeIs(1));
}

TEST(SectionText, ABuildingSaysWhichSectionIsWrong) {
  const auto with = [](const std::string& sections) {
    return parse_building(R"({"format": "aisle.building", "version": 1, "routes": [{"name": "route", )"
                          R"("start": {"at_m": [0, 0], "heading_deg": 0}, "sections": [)" +
                              sections + "]}]}",
                          "b.json");
  };
  ASSERT_TRUE(with(R"("a 3", "r 36", "a 2")").ok());
  EXPECT_NEAR(with(R"("a 3", "r 36", "a 2")")->routes[0].path.length_m(), 5, 1e-12);
  EXPECT_THAT(to_string(with(R"("a 3", "q 36")").problems()), HasSubstr("routes[0].sections[1]: 'q'"));
  EXPECT_THAT(to_string(with(R"("a 3", "h 2")").problems()), HasSubstr("routes[0].sections[1]: 'h'"));
  EXPECT_THAT(to_string(with("").problems()), HasSubstr("routes[0].sections: leads nowhere"));
  EXPECT_THAT(with("3").problems(), SizeIs(1));
}

TEST(SectionText, ABuildingWithSectionsIsReadAsItWasWritten) {
  Building building;
  Route route{.name = "route", .sections = list({"a 3.25 right 0.4", "c 0.5 0.6", "h 2", "r 36", "a 1"})};
  route.path = path_of(route.sections, {});
  building.routes.push_back(route);
  const std::string text = building_json(building);
  const auto read = parse_building(text, "b.json");
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_EQ(read->routes[0].sections, route.sections);
  EXPECT_EQ(building_json(*read), text);
}

}  // namespace
}  // namespace aisle
