#include "aisle/guidance/rooms/stop_view_matcher.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "aisle/vision/places/brightness_view.hpp"
#include "aisle/vision/places/column_view.hpp"

namespace aisle {
namespace {

/// The image with this much path left: a bright and a dark strip that move apart as the place comes near.
Image view_from(double left_m) {
  Image image(320, 100);
  std::fill(image.bytes.begin(), image.bytes.end(), std::uint8_t{100});
  const int apart = static_cast<int>(std::lround(120 / (1 + left_m)));
  for (int v = 0; v < image.height_px; ++v) {
    for (int i = -5; i <= 5; ++i) {
      image.row(v)[160 - apart + i] = 220;
      image.row(v)[160 + apart + i] = 10;
    }
  }
  return image;
}

std::vector<StopView> taught() {
  std::vector<StopView> views;
  for (int i = 0; i <= 20; ++i) {
    const Image view = view_from(0.05 * i);
    views.push_back({0.05 * i, {brightness_view(view), column_view(view)}});
  }
  return views;
}

/// Drives the last half metre while the odometry says 0.2 m less than is left.
void drive_up_to(StopViewMatcher& matcher) {
  for (int i = 0; i < 8; ++i) {
    const double really_left_m = 0.5 - 0.03 * i;
    matcher.take(view_from(really_left_m), really_left_m - 0.2);
  }
}

TEST(StopViewMatcher, CorrectsThePathLeft) {
  for (const bool by_extremes : {false, true}) {
    StopViewMatcher matcher({.by_extremes = by_extremes}, taught());
    drive_up_to(matcher);
    EXPECT_NEAR(matcher.shift_m(), 0.2, 0.05);
    EXPECT_TRUE(matcher.has_matched());
  }
}

TEST(StopViewMatcher, ViewsOfAnEarlierVersionAreComparedByTheirExtremes) {
  std::vector<StopView> views = taught();
  for (StopView& view : views) view.seen.columns = {};
  StopViewMatcher matcher({}, views);
  drive_up_to(matcher);
  EXPECT_NEAR(matcher.shift_m(), 0.2, 0.05);
}

TEST(StopViewMatcher, OneMatchAloneDoesNotCount) {
  StopViewMatcher matcher({}, taught());
  matcher.take(view_from(0.5), 0.2);
  matcher.take(Image(320, 100), 0.17);
  matcher.take(view_from(0.44), 0.14);
  EXPECT_EQ(matcher.shift_m(), 0);
  EXPECT_FALSE(matcher.has_matched());
}

TEST(StopViewMatcher, IgnoresViewsFarFromThePlace) {
  StopViewMatcher matcher({}, taught());
  for (int i = 0; i < 8; ++i) matcher.take(view_from(0.5), 6);
  EXPECT_EQ(matcher.shift_m(), 0);
}

}  // namespace
}  // namespace aisle
