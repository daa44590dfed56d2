#include "aisle/vision/places/column_view.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

/// Bright and dark columns as wide as one of a view, of tones that only chance knows.
Image any_image(std::uint64_t seed) {
  Random random(seed);
  Image image(kViewColumns, 2 * kViewBands);
  for (std::uint8_t& grey : image.bytes) grey = static_cast<std::uint8_t>(60 + random.index(120));
  return image;
}

/// The view with another heading: shifted to the left by some columns, the last ones repeated.
Image shifted(const Image& image, int columns) {
  Image seen = image;
  for (int v = 0; v < seen.height_px; ++v) {
    for (int u = 0; u < seen.width_px; ++u)
      seen.row(v)[u] = image.row(v)[std::clamp(u + columns, 0, image.width_px - 1)];
  }
  return seen;
}

Image dimmed(Image image) {
  for (std::uint8_t& grey : image.bytes) grey = static_cast<std::uint8_t>(grey * 7 / 10);
  return image;
}

/// From nearer to the corridor's end in the middle: what was at x / (1 + a |x|) is now at x.
Image approached(const Image& image, double approach) {
  Image seen = image;
  for (int v = 0; v < seen.height_px; ++v) {
    for (int u = 0; u < seen.width_px; ++u) {
      const double x = (u + 0.5) / seen.width_px - 0.5;
      const double before = x / (1 + approach * std::abs(x));
      seen.row(v)[u] = image.row(v)[static_cast<int>((before + 0.5) * image.width_px)];
    }
  }
  return seen;
}

double unlikeness(const Image& a, const Image& b, const ColumnViewParams& params) {
  return ViewCurves(params, column_view(a)).unlikeness(ViewCurves(params, column_view(b)));
}

TEST(ColumnView, HasARowForEachBandAndAPixelForEachColumn) {
  Image image(2 * kViewColumns, 2 * kViewBands);
  image.row(0)[0] = 100;
  const Image view = column_view(image);
  EXPECT_EQ(view.width_px, kViewColumns);
  EXPECT_EQ(view.height_px, kViewBands);
  EXPECT_EQ(view.row(0)[0], 25);
  EXPECT_EQ(view.row(1)[0], 0);
}

TEST(ViewCurves, OtherLightAndAnotherHeadingLeaveAPlaceAlike) {
  const Image image = any_image(1);
  EXPECT_NEAR(unlikeness(image, image, {}), 0, 0.01);
  EXPECT_LT(unlikeness(image, dimmed(image), {}), 0.02);
  EXPECT_LT(unlikeness(image, shifted(image, 9), {}), 0.02);
  EXPECT_GT(unlikeness(image, shifted(image, 9), {.lateral_max = 0.02}), 0.5);
  EXPECT_GT(unlikeness(image, any_image(2), {}), 0.5);
}

TEST(ViewCurves, TheSamePlaceIsAlikeFromNearerWhicheverIsSeenFirst) {
  const ColumnViewParams params{.lateral_max = 0.05, .approach_max = 2};
  const Image far = any_image(3), near = approached(far, 2);
  EXPECT_LT(unlikeness(far, near, params), 0.2);
  EXPECT_GT(unlikeness(far, near, {.lateral_max = 0.05}), 0.5);
  EXPECT_DOUBLE_EQ(unlikeness(far, near, params), unlikeness(near, far, params));
}

TEST(ViewCurves, WhereNothingIsSeenNothingIsAlike) {
  const Image bare(kViewColumns, kViewBands);
  EXPECT_NEAR(unlikeness(bare, any_image(4), {}), 1, 0.1);
  EXPECT_NEAR(unlikeness(bare, bare, {}), 1, 1e-6);
}

/// One minus the correlation, word by word, for each shift.
double plain_unlikeness(const Image& a, const Image& b, int lateral_max) {
  double best = -1;
  for (int lateral = -lateral_max; lateral <= lateral_max; ++lateral) {
    double both = 0, of_a = 0, of_b = 0;
    const int from = std::max(0, -lateral), to = std::min(kViewColumns, kViewColumns - lateral);
    for (int band = 0; band < kViewBands; ++band) {
      const auto tone = [&](const Image& view, int u) { return std::log(view.row(band)[u] + 10.0); };
      double mean_a = 0, mean_b = 0;
      for (int u = from; u < to; ++u) {
        mean_a += tone(a, u) / (to - from);
        mean_b += tone(b, u + lateral) / (to - from);
      }
      for (int u = from; u < to; ++u) {
        const double off_a = tone(a, u) - mean_a, off_b = tone(b, u + lateral) - mean_b;
        both += off_a * off_b;
        of_a += off_a * off_a;
        of_b += off_b * off_b;
      }
    }
    best = std::max(best, both / std::sqrt(of_a * of_b));
  }
  return 1 - best;
}

RC_GTEST_PROP(ViewCurves, AreComparedAsTheDefinitionSays, (std::uint64_t seed)) {
  const ColumnViewParams params{.lateral_max = 0.1};
  const Image a = column_view(any_image(seed)), b = column_view(shifted(any_image(seed + seed % 2), 5));
  const double unlike = ViewCurves(params, a).unlikeness(ViewCurves(params, b));
  RC_ASSERT(std::abs(unlike - plain_unlikeness(a, b, 13)) < 0.005);
}

}  // namespace
}  // namespace aisle
