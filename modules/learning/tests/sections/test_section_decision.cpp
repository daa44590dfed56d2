#include <gmock/gmock.h>

#include "aisle/learning/sections/section_learning.hpp"
#include "driven_sections.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using Kind = Section::Kind;

std::vector<Kind> kinds(const SectionList& sections) {
  std::vector<Kind> all;
  for (const Section& section : sections) all.push_back(section.kind);
  return all;
}

std::vector<Kind> decided(const SectionList& driven, std::optional<double> width_m = {}) {
  return kinds(decide_sections(driven, width_m, {}));
}

TEST(SectionDecision, TwoLeftTurnsThatSumToAQuarterAreACorner) {
  const SectionList list =
      decide_sections({straight(5), turn(45), straight(0.6), turn(45), straight(3)}, {}, {});
  EXPECT_THAT(kinds(list), ElementsAre(Kind::kFollow, Kind::kCurve, Kind::kFollow));
  // L03 section 3.2 A: P2 is the chord, turned by the first angle
  EXPECT_NEAR(list[1].p_start_end.x(), 0.6 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(list[1].p_start_end.y(), 0.6 * std::sqrt(0.5), 1e-12);
}

TEST(SectionDecision, TurnsThatMissAQuarterByMoreThanTheThresholdAreNoCorner) {
  const double off_deg = to_degrees(SectionLearningParams{}.corner_rad);
  EXPECT_THAT(decided({straight(5), turn(45), straight(0.6), turn(44 - off_deg), straight(3)}),
              testing::Not(testing::Contains(Kind::kCurve)));
  EXPECT_THAT(decided({straight(5), turn(45), straight(0.6), turn(46 - off_deg), straight(3)}),
              testing::Contains(Kind::kCurve));
}

TEST(SectionDecision, RightTurnsAreNoCornersButEndHybridSections) {
  EXPECT_THAT(decided({straight(5), turn(-90), straight(3)}),
              ElementsAre(Kind::kHybrid, Kind::kTurn, Kind::kFollow));
}

TEST(SectionDecision, APathAcrossTheCorridorIsDeadReckoned) {
  // 0.4 m are kept from the right before and after, the corridor is 1.8 m wide: 1 m across
  const SectionList driven = {straight(5, 0.4), turn(90), straight(1.0), turn(90), straight(5, 0.4)};
  EXPECT_THAT(decided(driven, 1.8),
              ElementsAre(Kind::kFollow, Kind::kTurn, Kind::kDead, Kind::kTurn, Kind::kFollow));
  EXPECT_THAT(decided(driven, 2.3), testing::Not(testing::Contains(Kind::kDead)));
  EXPECT_THAT(decided(driven), testing::Not(testing::Contains(Kind::kDead)));
}

TEST(SectionDecision, BackwardsAndTurnsStayAsTheyAre) {
  const Section back{.kind = Kind::kBack, .length_m = 0.4};
  EXPECT_THAT(decided({straight(2), back, turn(45), straight(2)}),
              ElementsAre(Kind::kFollow, Kind::kBack, Kind::kTurn, Kind::kFollow));
  EXPECT_TRUE(decided({}).empty());
}

}  // namespace
}  // namespace aisle
