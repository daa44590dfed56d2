#include "aisle/vision/check/view_check.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

namespace aisle {
namespace {

using testing::Contains;
using testing::Not;

/// A view in which everything is seen and agrees.
ImageEvidence good_evidence() {
  ImageEvidence image;
  image.width_px = 640;
  image.height_px = 480;
  image.quality = {.dark_share = 0, .bright_share = 0, .contrast = 150, .blur_across = 0.3, .blur_down = 0.3};
  image.left = image.right = {.is_found = true, .floor_beneath = 1, .wall_above = 1, .is_found_again = true};
  image.vanishing_point = Vec2(0.5, 0.45);
  image.verticals = 12;
  image.verticals_left = 6;
  image.standing = 5;
  image.found_again = 11;
  image.lean_rad = 0.0;
  image.floor_share = 0.25;
  image.floor_left_share = 0.5;
  image.floor_top = 0.5;
  image.floor_overlap = 0.95;
  return image;
}

ViewCheck check_of(const std::vector<ImageEvidence>& images, const std::vector<PairEvidence>& pairs = {}) {
  return check_views(images, pairs, true);
}

TEST(ViewCheck, GoodViewsAreSeenAndNeedNoHint) {
  const ViewCheck check = check_of(std::vector(20, good_evidence()));
  for (const FeatureCheck* of : {&check.right_edge, &check.left_edge, &check.verticals, &check.floor_points,
                                 &check.floor, &check.landmarks, &check.sections, &check.rooms}) {
    EXPECT_EQ(of->verdict, ViewVerdict::kSeen);
    EXPECT_EQ(of->good, 20);
  }
  EXPECT_TRUE(check.hints.empty());
}

TEST(ViewCheck, OneImageIsNeverJudgedHoweverGood) {
  const ViewCheck check = check_of({good_evidence()});
  EXPECT_EQ(check.sections.verdict, ViewVerdict::kNotJudged);
  EXPECT_EQ(check.sections.good, 1);
  EXPECT_LT(check.sections.share_low, 0.5);
  EXPECT_THAT(check.hints, Contains(ViewHint::kMoreImages));
}

TEST(ViewCheck, AMajorityThatChanceExplainsIsDoubtful) {
  const ViewCheckParams params;
  EXPECT_EQ(judged(7, 10, params).verdict, ViewVerdict::kDoubtful);
  EXPECT_EQ(judged(70, 100, params).verdict, ViewVerdict::kSeen);
  EXPECT_EQ(judged(50, 100, params).verdict, ViewVerdict::kNotSeen);
  EXPECT_EQ(judged(4, 4, params).verdict, ViewVerdict::kNotJudged);
  EXPECT_EQ(judged(0, 0, params).verdict, ViewVerdict::kNotJudged);
}

TEST(ViewCheck, TheIntervalIsWilsons) {
  const FeatureCheck check = judged(8, 10, {});  // by hand: (0.8 + z2 / 20 +- ...) / (1 + z2 / 10), z = 1.645
  EXPECT_NEAR(check.share_low, 0.541, 0.001);
  EXPECT_NEAR(check.share_high, 0.931, 0.001);
}

TEST(ViewCheck, AnEdgeThatIsNotFoundAgainOrHasNoFloorBeneathIsNotGood) {
  std::vector<ImageEvidence> images(20, good_evidence());
  for (ImageEvidence& image : images) {
    image.right.is_found_again = false;
    image.left.floor_beneath = 0.1;
  }
  const ViewCheck check = check_of(images);
  EXPECT_EQ(check.right_edge.verdict, ViewVerdict::kNotSeen);
  EXPECT_EQ(check.left_edge.verdict, ViewVerdict::kNotSeen);
  EXPECT_EQ(check.sections.verdict, ViewVerdict::kNotSeen);
  EXPECT_EQ(check.rooms.verdict, ViewVerdict::kSeen);
}

TEST(ViewCheck, AnEdgeToAnotherHorizonThanTheOthersIsNotGood) {
  std::vector<ImageEvidence> images(20, good_evidence());
  for (std::size_t i = 0; i < 4; ++i) images[i].vanishing_point = Vec2(0.5, 0.8);
  EXPECT_EQ(check_of(images).right_edge.good, 16);
  images[0].width_px = 320;  // of several cameras there is no common horizon
  EXPECT_EQ(check_of(images).right_edge.good, 20);
  EXPECT_FALSE(check_of(images).medians.horizon);
}

TEST(ViewCheck, FloorThatChangesWithTheLightOrClimbsTheWallsIsNotGood) {
  std::vector<ImageEvidence> images(20, good_evidence());
  for (std::size_t i = 0; i < 8; ++i) images[i].floor_overlap = 0.3;
  for (std::size_t i = 8; i < 16; ++i) images[i].floor_beyond_edges = 0.9;
  for (std::size_t i = 16; i < 18; ++i) images[i].floor_above_end = 0.5;
  const ViewCheck check = check_of(images);
  EXPECT_EQ(check.floor.good, 2);
  EXPECT_EQ(check.rooms.verdict, ViewVerdict::kNotSeen);
  EXPECT_THAT(check.hints, Contains(ViewHint::kFloorUnclear));
}

TEST(ViewCheck, OverACarpetTheCorridorsEndSaysNothingAboutTheFloor) {
  std::vector<ImageEvidence> images(20, good_evidence());
  for (ImageEvidence& image : images) {
    image.left = image.right = {};
    image.found_again = image.verticals = image.standing = 0;
    image.floor_above_end = 0.5;
  }
  EXPECT_EQ(check_of(images).rooms.verdict, ViewVerdict::kSeen);
}

TEST(ViewCheck, VerticalsWithoutFeetAreNotEnoughForLandmarks) {
  std::vector<ImageEvidence> images(20, good_evidence());
  for (ImageEvidence& image : images) image.standing = 0;
  const ViewCheck check = check_of(images);
  EXPECT_EQ(check.verticals.verdict, ViewVerdict::kSeen);
  EXPECT_EQ(check.landmarks.verdict, ViewVerdict::kNotSeen);
  EXPECT_THAT(check.hints, Contains(ViewHint::kFeetUnseen));
}

struct HintCase {
  const char* name;
  ViewHint hint;
  void (*spoil)(ImageEvidence&);

  friend void PrintTo(const HintCase& one, std::ostream* out) { *out << one.name; }
};

class ViewHints : public testing::TestWithParam<HintCase> {};

TEST_P(ViewHints, AreGivenForWhatIsWrongAndForNothingElse) {
  std::vector<ImageEvidence> images(20, good_evidence());
  for (ImageEvidence& image : images) GetParam().spoil(image);
  EXPECT_THAT(check_of(images).hints, testing::ElementsAre(GetParam().hint));
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ViewHints,
    testing::Values(
        HintCase{"Small", ViewHint::kSmall, [](ImageEvidence& image) { image.width_px = 160; }},
        HintCase{"Dark", ViewHint::kDark, [](ImageEvidence& image) { image.quality.dark_share = 0.6; }},
        HintCase{"Bright", ViewHint::kBright, [](ImageEvidence& image) { image.quality.bright_share = 0.6; }},
        HintCase{"Flat", ViewHint::kFlat, [](ImageEvidence& image) { image.quality.contrast = 20; }},
        HintCase{"BlurAcross", ViewHint::kBlurAcross,
                 [](ImageEvidence& image) { image.quality.blur_across = 0.8; }},
        HintCase{"BlurDown", ViewHint::kBlurDown,
                 [](ImageEvidence& image) { image.quality.blur_down = 0.8; }},
        HintCase{"LooksUp", ViewHint::kLooksUp,
                 [](ImageEvidence& image) { image.vanishing_point = Vec2(0.5, 0.8); }},
        HintCase{"LooksDown", ViewHint::kLooksDown,
                 [](ImageEvidence& image) { image.vanishing_point = Vec2(0.5, 0.1); }},
        HintCase{"Rolled", ViewHint::kRolled, [](ImageEvidence& image) { image.lean_rad = -0.2; }},
        HintCase{"OneSided", ViewHint::kOneSided, [](ImageEvidence& image) { image.left.is_found = false; }}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(ViewCheck, AnUnknownLensIsAHint) {
  const std::vector<ImageEvidence> images(20, good_evidence());
  EXPECT_THAT(check_views(images, {}, false).hints, testing::ElementsAre(ViewHint::kLensUnknown));
}

TEST(ViewCheck, AHorizonThatMovesIsAHint) {
  std::vector<ImageEvidence> images(20, good_evidence());
  for (std::size_t i = 0; i < 10; ++i) images[i].vanishing_point = Vec2(0.5, 0.25);
  EXPECT_THAT(check_of(images).hints, Contains(ViewHint::kNods));
}

TEST(ViewCheck, OnlyImagesThatAreAlikeTellHowSteadyItIs) {
  PairEvidence pair{.is_alike = true,
                    .left_came = true,
                    .left_stayed = true,
                    .right_came = true,
                    .right_stayed = false,
                    .verticals = 10,
                    .followed = 8,
                    .floor_overlap = 0.9};
  PairEvidence other = pair;
  other.is_alike = false;
  const SteadinessCheck steady =
      check_of(std::vector(6, good_evidence()), {pair, other, pair, other, other}).steadiness;
  EXPECT_EQ(steady.pairs, 2);
  EXPECT_EQ(steady.edges, 4);
  EXPECT_EQ(steady.edges_stayed, 2);
  EXPECT_EQ(steady.verticals, 20);
  EXPECT_EQ(steady.verticals_followed, 16);
  EXPECT_DOUBLE_EQ(steady.floor_overlap, 0.9);
}

TEST(ViewCheck, WithoutImagesThereIsNone) {
  EXPECT_THROW(check_of({}), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
