#include "aisle/vision/places/brightness_view.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace aisle {
namespace {

/// Grey, with a bright and a dark strip over a part of the rows.
Image with_strips(int bright_u, int dark_u, int from_row, int to_row) {
  Image image(200, 100);
  std::fill(image.bytes.begin(), image.bytes.end(), std::uint8_t{100});
  for (int v = from_row; v < to_row; ++v) {
    for (int i = -4; i <= 4; ++i) {
      image.row(v)[bright_u + i] = 220;
      image.row(v)[dark_u + i] = 10;
    }
  }
  return image;
}

TEST(BrightnessView, FindsTheBrightestAndTheDarkestColumnOfEachHalf) {
  const auto upper = brightness_view(with_strips(50, 150, 0, 50));
  EXPECT_NEAR(upper[0], 0.25, 0.03);
  EXPECT_NEAR(upper[1], 0.75, 0.03);
  EXPECT_NEAR(upper[4], 0.5, 0.05) << "the bright strip lies in the middle of the left half";
  EXPECT_NEAR(upper[7], 0.5, 0.05) << "the dark one in the middle of the right half";
  const auto lower = brightness_view(with_strips(50, 150, 50, 100));
  EXPECT_NEAR(lower[2], 0.25, 0.03);
  EXPECT_NEAR(lower[3], 0.75, 0.03);
}

TEST(BrightnessView, OtherLightLeavesItAsItIs) {
  Image bright = with_strips(60, 140, 0, 100), dim = bright;
  for (std::uint8_t& grey : dim.bytes) grey = static_cast<std::uint8_t>(grey * 7 / 10);
  EXPECT_EQ(brightness_view(bright), brightness_view(dim));
}

}  // namespace
}  // namespace aisle
