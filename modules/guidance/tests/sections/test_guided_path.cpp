#include "aisle/guidance/sections/guided_path.hpp"

#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

Section follow(double length_m, std::optional<double> right_m, std::optional<double> left_m) {
  return {.kind = Section::Kind::kFollow, .length_m = length_m, .right_m = right_m, .left_m = left_m};
}
const Section kRightTurn{.kind = Section::Kind::kTurn, .turn_rad = -kPi / 2};

/// Round a right corner of a corridor 1.2 m wide, half a metre from the left walls.
const SectionList kRoundTheCorner = {follow(5, 0.7, 0.5), kRightTurn, follow(3, 0.7, 0.5)};

TEST(GuidedPath, TheNextSectionsBaseLinesAreTheWallAheadAndTheCorner) {
  const GuidedPath guided = guided_path(kRoundTheCorner, {1, 2, 0.3}, SectionRun::kThere);
  const SectionGuide& first = guided.guides.front();
  EXPECT_TRUE(first.turns_right);
  ASSERT_TRUE(first.ahead_m && first.line_ends_m);
  EXPECT_NEAR(*first.ahead_m, 0.5, 1e-9);
  EXPECT_NEAR(*first.line_ends_m, 0.7, 1e-9);
  EXPECT_FALSE(guided.guides.back().ahead_m);
}

TEST(GuidedPath, AMeasuredWallAheadOverridesTheNextSection) {
  SectionList sections = kRoundTheCorner;
  sections[0].ahead_m = 0.53;
  EXPECT_NEAR(*guided_path(sections, {}, SectionRun::kThere).guides.front().ahead_m, 0.53, 1e-9);
}

TEST(GuidedPath, OnTheWayBackSidesSwapAndThePreviousSectionGivesTheWallAhead) {
  SectionList sections = kRoundTheCorner;
  sections[2].ahead_m = 0.9;  // a dead end, behind the vehicle on the return path
  const GuidedPath guided = guided_path(sections, {}, SectionRun::kBack);
  const SectionGuide& first = guided.guides.front();
  EXPECT_FALSE(first.turns_right);
  EXPECT_EQ(first.right_m, 0.5);
  EXPECT_EQ(first.left_m, 0.7);
  EXPECT_NEAR(*first.ahead_m, 0.5, 1e-9);
  EXPECT_NEAR(*first.line_ends_m, 0.7, 1e-9);
}

TEST(GuidedPath, ThereAndBackEndsAsItBegan) {
  const GuidedPath guided = guided_path(kRoundTheCorner, {}, SectionRun::kThereAndBack);
  const Pose2 T_end = guided.path.end();
  EXPECT_NEAR(T_end.position().norm(), 0, 1e-9);
  EXPECT_NEAR(wrap_angle(T_end.theta), 0, 1e-9);
  EXPECT_EQ(guided.guides.size(), guided.path.pieces().size());
}

}  // namespace
}  // namespace aisle
