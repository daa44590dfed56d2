#include "aisle/vision/check/image_evidence.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "drawn_corridor.hpp"

namespace aisle {
namespace {

Image with_sensor_noise(Image image) {
  Random random(3);
  for (auto& byte : image.bytes)
    byte = static_cast<std::uint8_t>(std::clamp(std::lround(byte + random.normal(2)), 0L, 255L));
  return image;
}

/// The mean of `pixels` pixels in a row, as a camera that turns sees them.
Image smeared_sideways(const Image& image, int pixels) {
  Image smeared = image;
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) {
      int sum = 0;
      for (int k = 0; k < pixels; ++k)
        sum += image.row(v)[std::clamp(u + k - pixels / 2, 0, image.width_px - 1)];
      smeared.row(v)[u] = static_cast<std::uint8_t>(sum / pixels);
    }
  }
  return smeared;
}

TEST(ImageEvidence, ADrawnCorridorIsSeenAndFoundAgain) {
  const ImageEvidence evidence = ImageExaminer().examine(with_sensor_noise(DrawnCorridor().image()));
  EXPECT_TRUE(evidence.right.is_found && evidence.right.is_found_again);
  EXPECT_TRUE(evidence.left.is_found && evidence.left.is_found_again);
  EXPECT_GT(evidence.right.floor_beneath, 0.9);
  EXPECT_GT(evidence.right.wall_above, 0.9);
  ASSERT_TRUE(evidence.vanishing_point);
  EXPECT_NEAR(evidence.vanishing_point->x(), 0.5, 0.02);
  EXPECT_NEAR(evidence.vanishing_point->y(), 0.5, 0.02);
  EXPECT_GE(evidence.verticals, 6);
  EXPECT_GE(evidence.found_again, evidence.verticals * 3 / 4);
  EXPECT_GE(evidence.standing, 4);
  ASSERT_TRUE(evidence.lean_rad);
  EXPECT_NEAR(*evidence.lean_rad, 0, 0.02);
  EXPECT_GT(evidence.floor_overlap, 0.9);
  EXPECT_LT(evidence.floor_beyond_edges, 0.1);
  EXPECT_LT(evidence.floor_above_end, 0.02);
  EXPECT_NEAR(evidence.floor_left_share, 0.5, 0.1);
}

TEST(ImageEvidence, ARolledCameraShowsLeaningLines) {
  DrawnCorridor corridor;
  corridor.roll_rad = 0.1;
  const ImageEvidence evidence = ImageExaminer().examine(with_sensor_noise(corridor.image()));
  ASSERT_TRUE(evidence.lean_rad);
  EXPECT_NEAR(std::abs(*evidence.lean_rad), 0.1, 0.03);
}

TEST(ImageEvidence, ABareWallShowsNothing) {
  const ImageEvidence evidence = ImageExaminer().examine(with_sensor_noise([] {
    Image wall(320, 240);
    std::fill(wall.bytes.begin(), wall.bytes.end(), std::uint8_t{128});
    return wall;
  }()));
  EXPECT_FALSE(evidence.right.is_found);
  EXPECT_FALSE(evidence.left.is_found);
  EXPECT_EQ(evidence.standing, 0);
}

TEST(ImageEvidence, ATinyImageHasNoSecondLook) {
  const ImageEvidence evidence = ImageExaminer().examine(Image(20, 10));
  EXPECT_EQ(evidence.width_px, 20);
  EXPECT_EQ(evidence.floor_overlap, 0);
}

TEST(ImageQualityOf, TellsTheDirectionOfBlur) {
  Image squares(320, 240);
  for (int v = 0; v < 240; ++v)
    for (int u = 0; u < 320; ++u) squares.row(v)[u] = (u / 40 + v / 40) % 2 == 0 ? 40 : 200;
  const ImageQuality before = image_quality(squares), smeared = image_quality(smeared_sideways(squares, 21));
  EXPECT_NEAR(before.blur_across, 1.0 / 9, 0.01) << "of a step, the ninth part is left from pixel to pixel";
  EXPECT_NEAR(before.blur_down, 1.0 / 9, 0.01);
  EXPECT_GT(smeared.blur_across, 0.6);
  EXPECT_LT(smeared.blur_down, 0.2);
}

TEST(ImageQualityOf, CountsWhatIsBlackAndWhatIsBurntOut) {
  Image image(100, 40);
  for (int v = 0; v < 40; ++v)
    for (int u = 0; u < 100; ++u) image.row(v)[u] = u < 30 ? 2 : u < 40 ? 255 : 100;
  const ImageQuality quality = image_quality(image);
  EXPECT_NEAR(quality.dark_share, 0.3, 1e-9);
  EXPECT_NEAR(quality.bright_share, 0.1, 1e-9);
  EXPECT_EQ(quality.contrast, 253);
}

TEST(PairEvidence, TheSameImageTwiceIsSteady) {
  const Image image = with_sensor_noise(DrawnCorridor().image());
  ImageExaminer examiner;
  PairExaminer pairs;
  const ImageEvidence evidence = examiner.examine(image);
  EXPECT_FALSE(pairs.take(image, examiner.lines(), examiner.floor()));
  const auto pair = pairs.take(image, examiner.lines(), examiner.floor());
  ASSERT_TRUE(pair);
  EXPECT_TRUE(pair->is_alike);
  EXPECT_TRUE(pair->left_stayed && pair->right_stayed);
  EXPECT_EQ(pair->followed, evidence.verticals);
  EXPECT_EQ(pair->floor_overlap, 1);
  pairs.forget();
  EXPECT_FALSE(pairs.take(image, examiner.lines(), examiner.floor()));
}

TEST(PairEvidence, ImagesOfDifferentPlacesAreNotAlike) {
  DrawnCorridor other;
  other.end_m = 2.5;
  other.left_m = -3;
  ImageExaminer examiner;
  PairExaminer pairs;
  const Image one = DrawnCorridor().image(), two = other.image();
  examiner.examine(one);
  pairs.take(one, examiner.lines(), examiner.floor());
  examiner.examine(two);
  const auto pair = pairs.take(two, examiner.lines(), examiner.floor());
  ASSERT_TRUE(pair);
  EXPECT_FALSE(pair->is_alike);
}

}  // namespace
}  // namespace aisle
