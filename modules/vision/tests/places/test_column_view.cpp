#include "aisle/vision/places/column_view.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

/// Bright and dark columns as wide as one of a view, of tones that only chance knows.
Image any_picture(std::uint64_t seed) {
  Random random(seed);
  Image picture(kViewColumns, 2 * kViewBands);
  for (std::uint8_t& grey : picture.bytes) grey = static_cast<std::uint8_t>(60 + random.index(120));
  return picture;
}

/// What is seen of it with another heading: so many columns farther left, the last ones repeated.
Image shifted(const Image& picture, int columns) {
  Image seen = picture;
  for (int v = 0; v < seen.height_px; ++v) {
    for (int u = 0; u < seen.width_px; ++u)
      seen.row(v)[u] = picture.row(v)[std::clamp(u + columns, 0, picture.width_px - 1)];
  }
  return seen;
}

Image dimmed(Image picture) {
  for (std::uint8_t& grey : picture.bytes) grey = static_cast<std::uint8_t>(grey * 7 / 10);
  return picture;
}

/// From nearer to the corridor's end in the middle: what was at x / (1 + a |x|) is now at x.
Image approached(const Image& picture, double approach) {
  Image seen = picture;
  for (int v = 0; v < seen.height_px; ++v) {
    for (int u = 0; u < seen.width_px; ++u) {
      const double x = (u + 0.5) / seen.width_px - 0.5;
      const double before = x / (1 + approach * std::abs(x));
      seen.row(v)[u] = picture.row(v)[static_cast<int>((before + 0.5) * picture.width_px)];
    }
  }
  return seen;
}

double unlikeness(const Image& a, const Image& b, const ColumnViewParams& params) {
  return ViewCurves(params, column_view(a)).unlikeness(ViewCurves(params, column_view(b)));
}

TEST(ColumnView, HasARowForEachBandAndAPixelForEachColumn) {
  Image picture(2 * kViewColumns, 2 * kViewBands);
  picture.row(0)[0] = 100;
  const Image view = column_view(picture);
  EXPECT_EQ(view.width_px, kViewColumns);
  EXPECT_EQ(view.height_px, kViewBands);
  EXPECT_EQ(view.row(0)[0], 25);
  EXPECT_EQ(view.row(1)[0], 0);
}

TEST(ViewCurves, OtherLightAndAnotherHeadingLeaveAPlaceAlike) {
  const Image picture = any_picture(1);
  EXPECT_NEAR(unlikeness(picture, picture, {}), 0, 0.01);
  EXPECT_LT(unlikeness(picture, dimmed(picture), {}), 0.02);
  EXPECT_LT(unlikeness(picture, shifted(picture, 9), {}), 0.02);
  EXPECT_GT(unlikeness(picture, shifted(picture, 9), {.aside_max = 0.02}), 0.5);
  EXPECT_GT(unlikeness(picture, any_picture(2), {}), 0.5);
}

TEST(ViewCurves, TheSamePlaceIsAlikeFromNearerWhicheverIsSeenFirst) {
  const ColumnViewParams params{.aside_max = 0.05, .approach_max = 2};
  const Image far = any_picture(3), near = approached(far, 2);
  EXPECT_LT(unlikeness(far, near, params), 0.2);
  EXPECT_GT(unlikeness(far, near, {.aside_max = 0.05}), 0.5);
  EXPECT_DOUBLE_EQ(unlikeness(far, near, params), unlikeness(near, far, params));
}

TEST(ViewCurves, WhereNothingIsSeenNothingIsAlike) {
  const Image bare(kViewColumns, kViewBands);
  EXPECT_NEAR(unlikeness(bare, any_picture(4), {}), 1, 0.1);
  EXPECT_NEAR(unlikeness(bare, bare, {}), 1, 1e-6);
}

/// One minus the correlation, word by word, for each shift.
double plain_unlikeness(const Image& a, const Image& b, int aside_max) {
  double best = -1;
  for (int aside = -aside_max; aside <= aside_max; ++aside) {
    double both = 0, of_a = 0, of_b = 0;
    const int from = std::max(0, -aside), to = std::min(kViewColumns, kViewColumns - aside);
    for (int band = 0; band < kViewBands; ++band) {
      const auto tone = [&](const Image& view, int u) { return std::log(view.row(band)[u] + 10.0); };
      double mean_a = 0, mean_b = 0;
      for (int u = from; u < to; ++u) {
        mean_a += tone(a, u) / (to - from);
        mean_b += tone(b, u + aside) / (to - from);
      }
      for (int u = from; u < to; ++u) {
        const double off_a = tone(a, u) - mean_a, off_b = tone(b, u + aside) - mean_b;
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
  const ColumnViewParams params{.aside_max = 0.1};
  const Image a = column_view(any_picture(seed)), b = column_view(shifted(any_picture(seed + seed % 2), 5));
  const double unlike = ViewCurves(params, a).unlikeness(ViewCurves(params, b));
  RC_ASSERT(std::abs(unlike - plain_unlikeness(a, b, 13)) < 0.005);
}

}  // namespace
}  // namespace aisle
