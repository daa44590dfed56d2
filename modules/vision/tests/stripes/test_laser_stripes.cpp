#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "aisle/core/random.hpp"
#include "aisle/vision/stripes/laser_stripes.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr int kWidth = 320, kHeight = 240;

struct Light {
  double red = 1, green = 1, blue = 1;  ///< shares of the stripe's brightness
};

/// A stripe with a Gaussian profile along a curve of rows, on a wall.
struct Scene {
  std::function<double(double)> row = [](double) { return 100.3; };
  double sigma_px = 1.2;
  double wall = 70, stripe = 120;
  double noise = 0;
  int first = 0, last = kWidth - 1;
};

std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

Image draw(const Scene& scene, int channels = 1, const Light& light = {}) {
  Image image(kWidth, kHeight, channels);
  Random random(7);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const double off = (v - scene.row(u)) / scene.sigma_px;
      const double lit = u >= scene.first && u <= scene.last ? scene.stripe * std::exp(-off * off / 2) : 0;
      const double shares[3] = {light.red, light.green, light.blue};
      for (int c = 0; c < channels; ++c) {
        image.row(v)[u * channels + c] =
            level(scene.wall + lit * (channels == 3 ? shares[c] : 1) + scene.noise * random.normal());
      }
    }
  }
  return image;
}

double greatest_error(const LaserStripe& stripe, const Scene& scene) {
  double greatest = 0;
  for (const Vec2& p : stripe.points_px) greatest = std::max(greatest, std::abs(p.y() - scene.row(p.x())));
  return greatest;
}

double rms_error(const LaserStripe& stripe, const Scene& scene) {
  double sum = 0;
  for (const Vec2& p : stripe.points_px) sum += std::pow(p.y() - scene.row(p.x()), 2);
  return std::sqrt(sum / static_cast<double>(stripe.points_px.size()));
}

RC_GTEST_PROP(LaserStripes, RowsAreFoundToATenthOfAPixel, ()) {
  const double row = *rc::gen::inRange(400, 2000) / 10.0, slope = *rc::gen::inRange(-50, 51) / 500.0;
  const double sigma_px = *rc::gen::inRange(70, 200) / 100.0;
  const Scene scene{.row = [=](double u) { return row + slope * u; }, .sigma_px = sigma_px};
  const auto stripes = find_laser_stripes(draw(scene));
  RC_ASSERT(stripes.size() == 1U);
  RC_ASSERT(stripes[0].points_px.size() == static_cast<std::size_t>(kWidth));
  RC_ASSERT(greatest_error(stripes[0], scene) <= 0.1);
}

TEST(LaserStripes, NoiseCostsLessThanAThirdOfAPixel) {
  const Scene scene{.row = [](double u) { return 90.2 + 0.1 * u; }, .noise = 6};
  const auto stripes = find_laser_stripes(draw(scene));
  ASSERT_THAT(stripes, SizeIs(1));
  EXPECT_GE(stripes[0].points_px.size(), 310);
  EXPECT_LE(rms_error(stripes[0], scene), 0.3);
}

TEST(LaserStripes, ASaturatedStripeIsCentred) {
  const Scene scene{.row = [](double) { return 80.4; }, .sigma_px = 2.5, .stripe = 900};
  const auto stripes = find_laser_stripes(draw(scene));
  ASSERT_THAT(stripes, SizeIs(1));
  EXPECT_LE(greatest_error(stripes[0], scene), 0.1);
}

TEST(LaserStripes, ColourIsUsed) {
  const Scene scene{.wall = 150, .stripe = 25};
  EXPECT_THAT(find_laser_stripes(draw(scene, 3, {1, 0.1, 0.1})), SizeIs(1));
  const StripeParams white_alone{.contrast_min = 15};
  EXPECT_THAT(find_laser_stripes(draw(scene, 3, {1, 0.1, 0.1}), white_alone), SizeIs(1));
  EXPECT_THAT(find_laser_stripes(draw(scene, 3, {1, 1, 1}), white_alone), IsEmpty());
}

TEST(LaserStripes, ARoomCornerSplitsAStripeIntoTwoSegments) {
  const Scene scene{.row = [](double u) { return 80 + 0.2 * std::abs(u - 150); }};
  const auto stripes = find_laser_stripes(draw(scene));
  ASSERT_THAT(stripes, SizeIs(1));
  ASSERT_THAT(stripes[0].corners_px, SizeIs(3));
  EXPECT_NEAR(stripes[0].corners_px[1].x(), 150, 1);
  EXPECT_NEAR(stripes[0].corners_px[1].y(), 80, 0.3);
}

TEST(LaserStripes, AnObstacleBreaksTheStripe) {
  const Scene scene{.row = [](double u) { return u < 100 || u > 200 ? 80 : 95; }};
  const auto stripes = find_laser_stripes(draw(scene));
  ASSERT_THAT(stripes, SizeIs(3));
  EXPECT_NEAR(stripes[1].points_px.front().x(), 100, 2);
  EXPECT_NEAR(stripes[1].points_px.back().x(), 200, 2);
  EXPECT_NEAR(stripes[1].points_px[50].y(), 95, 0.1);
}

TEST(LaserStripes, LampsWallsAndEdgesAreNoStripes) {
  Image image(kWidth, kHeight);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool is_lamp = std::hypot(u - 160, v - 40) < 25;
      image.row(v)[u] = is_lamp ? 255 : v > 150 ? 170 : 90;
    }
  }
  EXPECT_THAT(find_laser_stripes(image), IsEmpty());
}

TEST(LaserStripes, AFaintMirrorImageBelowIsLeftOut) {
  Image image = draw({});
  for (int u = 40; u < 280; ++u) image.row(180)[u] = static_cast<std::uint8_t>(image.row(180)[u] + 15);
  EXPECT_THAT(find_laser_stripes(image), SizeIs(1));
}

TEST(LaserStripes, NoiseIsNoStripe) {
  EXPECT_THAT(find_laser_stripes(draw({.stripe = 0, .noise = 10})), IsEmpty());
  EXPECT_THAT(find_laser_stripes(draw({.stripe = 0, .noise = 40})), IsEmpty());
}

TEST(LaserStripes, AMirroredImageHasMirroredStripes) {
  const Scene scene{.row = [](double u) { return 80.3 + 0.15 * u; }, .first = 60, .last = 250};
  Scene mirrored = scene;
  mirrored.row = [&](double u) { return scene.row(kWidth - 1 - u); };
  mirrored.first = kWidth - 1 - scene.last;
  mirrored.last = kWidth - 1 - scene.first;
  const auto a = find_laser_stripes(draw(scene)), b = find_laser_stripes(draw(mirrored));
  ASSERT_THAT(a, SizeIs(1));
  ASSERT_THAT(b, SizeIs(1));
  ASSERT_EQ(a[0].points_px.size(), b[0].points_px.size());
  for (std::size_t i = 0; i < a[0].points_px.size(); ++i) {
    const Vec2& p = a[0].points_px[i];
    const Vec2& q = b[0].points_px[b[0].points_px.size() - 1 - i];
    EXPECT_EQ(p.x(), kWidth - 1 - q.x());
    EXPECT_EQ(p.y(), q.y());
  }
}

TEST(LaserStripes, EmptyFlatAndTinyImagesHaveNone) {
  EXPECT_THAT(find_laser_stripes({}), IsEmpty());
  for (const int size : {1, 2, 3, 8, 50}) {
    for (const int channels : {1, 3}) EXPECT_THAT(find_laser_stripes(Image(size, size, channels)), IsEmpty());
  }
}

}  // namespace
}  // namespace aisle
