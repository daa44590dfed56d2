#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {
namespace {

/// Lenses from barrel to pincushion on a 640 x 480 image of 50 degrees; none folds back within the image.
CameraIntrinsics any_lens(Random& random) {
  CameraIntrinsics lens;
  lens.fx_px = random.uniform(660, 700);
  lens.fy_px = random.uniform(660, 700);
  lens.cx_px = random.uniform(310, 330);
  lens.cy_px = random.uniform(230, 250);
  lens.k1 = random.uniform(-0.25, 0.3);
  lens.k2 = random.uniform(-0.02, 0.05);
  lens.p1 = random.uniform(-0.005, 0.005);
  lens.p2 = random.uniform(-0.005, 0.005);
  lens.k3 = random.uniform(-0.005, 0.01);
  return lens;
}

/// The same with the denominator of OpenCV's rational model.
CameraIntrinsics any_rational_lens(Random& random) {
  CameraIntrinsics lens = any_lens(random);
  lens.model = LensModel::kRationalPolynomial;
  lens.k4 = random.uniform(-0.1, 0.3);
  lens.k5 = random.uniform(-0.02, 0.05);
  lens.k6 = random.uniform(-0.005, 0.005);
  return lens;
}

/// Fisheye lenses that see 150 degrees and more along the diagonal of 640 x 480.
CameraIntrinsics any_fisheye_lens(Random& random) {
  CameraIntrinsics lens{.model = LensModel::kEquidistant};
  lens.fx_px = random.uniform(280, 300);
  lens.fy_px = random.uniform(280, 300);
  lens.cx_px = random.uniform(310, 330);
  lens.cy_px = random.uniform(230, 250);
  lens.k1 = random.uniform(-0.02, 0.03);
  lens.k2 = random.uniform(-0.005, 0.01);
  lens.k3 = random.uniform(-0.002, 0.003);
  lens.k4 = random.uniform(-0.0005, 0.0005);
  return lens;
}

CameraIntrinsics any_lens_of_any_model(Random& random) {
  switch (random.index(3)) {
    case 0:
      return any_lens(random);
    case 1:
      return any_rational_lens(random);
    default:
      return any_fisheye_lens(random);
  }
}

/// Coefficients such as a failed calibration may give.
CameraIntrinsics any_wild_lens(Random& random) {
  CameraIntrinsics lens = any_lens(random);
  lens.k1 = random.uniform(-3, 3);
  lens.k2 = random.uniform(-3, 3);
  lens.k3 = random.uniform(-3, 3);
  lens.model = static_cast<LensModel>(random.index(3));
  lens.k4 = random.uniform(-3, 3);
  lens.k5 = random.uniform(-3, 3);
  lens.k6 = random.uniform(-3, 3);
  return lens;
}

Vec2 any_pixel(Random& random) {
  return {random.uniform(-0.5, 639.5), random.uniform(-0.5, 479.5)};
}

TEST(CameraModel, WithoutDistortionByHand) {
  const CameraModel camera(CameraIntrinsics{500, 400, 320, 240});
  EXPECT_EQ(camera.project({0, 0, 3}), Vec2(320, 240));
  EXPECT_EQ(camera.project({1, 0.5, 2}), Vec2(570, 340));  // right of and below the axis
  EXPECT_EQ(camera.ray({570, 340})->direction, Vec3(0.5, 0.25, 1));
}

TEST(CameraModel, WithDistortionByHand) {
  // x = 0.5, y = 0.25, r^2 = 0.3125: radial factor 1 - 0.0625 + 0.009765625, tangential parts
  // 2 * 0.01 * 0.125 - 0.02 * (0.3125 + 0.5) and 0.01 * (0.3125 + 0.125) - 2 * 0.02 * 0.125.
  const CameraModel camera(CameraIntrinsics{500, 400, 320, 240, -0.2, 0.1, 0.01, -0.02, 0});
  const auto pixel = camera.project({1, 0.5, 2});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 320 + 500 * (0.5 * 0.947265625 + 0.0025 - 0.01625), 1e-10);
  EXPECT_NEAR(pixel->y(), 240 + 400 * (0.25 * 0.947265625 + 0.004375 - 0.005), 1e-10);
}

TEST(CameraModel, TheThirdRadialCoefficientComesLast) {
  const CameraModel camera(CameraIntrinsics{500, 500, 0, 0, 0, 0, 0, 0, 0.5});
  EXPECT_NEAR(camera.project({0.5, 0, 1})->x(), 500 * 0.5 * (1 + 0.5 * std::pow(0.5, 6)), 1e-10);
}

RC_GTEST_PROP(CameraModel, ProjectUndoesRay, (std::uint64_t seed)) {
  Random random(seed);
  const CameraModel camera(any_lens_of_any_model(random));
  const Vec2 pixel = any_pixel(random);
  const auto ray = camera.ray(pixel);
  RC_ASSERT(ray.has_value());
  const auto again = camera.project(random.uniform(0.1, 20) * ray->direction);
  RC_ASSERT(again.has_value());
  RC_ASSERT((*again - pixel).norm() < 1e-8);
}

RC_GTEST_PROP(CameraModel, RayUndoesProject, (std::uint64_t seed)) {
  Random random(seed);
  const CameraModel camera(any_lens_of_any_model(random));
  const Vec3 direction{random.uniform(-0.6, 0.6), random.uniform(-0.5, 0.5), 1};
  const auto pixel = camera.project(direction);
  RC_ASSERT(pixel.has_value());
  const auto ray = camera.ray(*pixel);
  RC_ASSERT(ray.has_value());
  RC_ASSERT((ray->direction - direction).norm() < 1e-10);
}

RC_GTEST_PROP(CameraModel, AWildLensHasTheRightRayOrNone, (std::uint64_t seed)) {
  Random random(seed);
  const CameraModel camera(any_wild_lens(random));
  const Vec2 pixel = any_pixel(random);
  const auto ray = camera.ray(pixel);
  if (!ray) return;
  const auto again = camera.project(ray->direction);
  RC_ASSERT(again.has_value());
  RC_ASSERT((*again - pixel).norm() < 1e-8);
}

RC_GTEST_PROP(CameraModel, RayDerivativeMatchesNumericalDifferences, (std::uint64_t seed)) {
  Random random(seed);
  const CameraModel camera(any_lens_of_any_model(random));
  const Vec2 pixel = any_pixel(random);
  constexpr double kStep = 1e-3;
  Mat2 numerical;
  for (int i = 0; i < 2; ++i) {
    const Vec2 nudge = kStep * Vec2::Unit(i);
    numerical.col(i) =
        (camera.ray(pixel + nudge)->direction - camera.ray(pixel - nudge)->direction).head<2>() / (2 * kStep);
  }
  RC_ASSERT((camera.ray(pixel)->by_pixel - numerical).norm() < 1e-6 * numerical.norm());
}

TEST(CameraModel, AnEquidistantLensByHand) {
  // Along x at 45 degrees: theta = pi / 4, the radius is theta (1 + 0.1 theta^2 + 0.01 theta^8).
  CameraIntrinsics lens{500, 400, 320, 240, 0.1};
  lens.model = LensModel::kEquidistant;
  lens.k4 = 0.01;
  const double theta = std::atan(1.0);
  const double radius = theta * (1 + 0.1 * std::pow(theta, 2) + 0.01 * std::pow(theta, 8));
  EXPECT_NEAR(CameraModel(lens).project({2, 0, 2})->x(), 320 + 500 * radius, 1e-10);
  EXPECT_NEAR(CameraModel(lens).project({0, 2, 2})->y(), 240 + 400 * radius, 1e-10);
  EXPECT_EQ(CameraModel(lens).project({0, 0, 2}), Vec2(320, 240));
}

TEST(CameraModel, ARationalLensByHand) {
  // r^2 = 0.25: (1 + 0.025) / (1 + 0.05).
  CameraIntrinsics lens{500, 400, 320, 240, 0.1};
  lens.model = LensModel::kRationalPolynomial;
  lens.k4 = 0.2;
  EXPECT_NEAR(CameraModel(lens).project({1, 0, 2})->x(), 320 + 500 * 0.5 * 1.025 / 1.05, 1e-10);
}

TEST(CameraModel, TheFieldOfViewEndsWhereTheLensFolds) {
  EXPECT_NEAR(CameraModel(CameraIntrinsics{}).half_field_of_view_rad(), std::atan(10.0), 1e-12);
  CameraIntrinsics fisheye;
  fisheye.model = LensModel::kEquidistant;
  EXPECT_NEAR(CameraModel(fisheye).half_field_of_view_rad(), 89 * kDegree, 1e-9);
  fisheye.k1 = -1.0 / 3;  // theta (1 - theta^2 / 3) grows up to 1
  EXPECT_NEAR(CameraModel(fisheye).half_field_of_view_rad(), 1, 1e-9);
  CameraIntrinsics rational;
  rational.model = LensModel::kRationalPolynomial;
  rational.k4 = 1;  // r / (1 + r^2) grows up to 1
  EXPECT_NEAR(CameraModel(rational).half_field_of_view_rad(), std::atan(1.0), 1e-9);
  rational.k4 = -4;  // a pole at r = 1 / 2
  EXPECT_NEAR(CameraModel(rational).half_field_of_view_rad(), std::atan(0.5), 1e-9);
}

TEST(CameraModel, AFisheyeLensHasARayForEveryPixelThatItSees) {
  CameraIntrinsics lens{230, 230, 319.5, 239.5};
  lens.model = LensModel::kEquidistant;
  const CameraModel camera(lens);
  for (int v = 0; v < 480; v += 7) {
    for (int u = 0; u < 640; u += 7) {
      const double theta = Vec2(u - 319.5, v - 239.5).norm() / 230;
      const auto ray = camera.ray({u, v});
      ASSERT_EQ(ray.has_value(), theta < 89 * kDegree) << u << ' ' << v;
      if (ray) {
        ASSERT_LT((*camera.project(ray->direction) - Vec2(u, v)).norm(), 1e-8);
      }
    }
  }
}

TEST(CameraModel, NothingBehindOrBesideTheCameraIsSeen) {
  const CameraModel camera(CameraIntrinsics{});
  EXPECT_FALSE(camera.project({0, 0, -1}));
  EXPECT_FALSE(camera.project({1, 0, 0}));
  EXPECT_FALSE(camera.project({0, 0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST(CameraModel, WhereTheDistortionFoldsBackThereIsNoPixelAndNoRay) {
  // r (1 - r^2 / 3) grows up to r = 1, where it is 2/3.
  CameraIntrinsics lens{500, 500, 0, 0};
  lens.k1 = -1.0 / 3;
  const CameraModel camera(lens);
  EXPECT_TRUE(camera.project({0.999, 0, 1}));
  EXPECT_FALSE(camera.project({1.001, 0, 1}));
  EXPECT_FALSE(camera.project({1.5, 0, 1}));
  EXPECT_NEAR(camera.ray({0.999 * 500 * 2 / 3, 0})->direction.x(), 1, 0.05);
  EXPECT_FALSE(camera.ray({1.001 * 500 * 2 / 3, 0}));
}

TEST(CameraModel, AFoldThatHigherTermsUnfoldAgainIsStillAFold) {
  // The growth 1 - 3 q + 2.1 q^2 is negative between q = 0.53 and q = 0.90 only.
  CameraIntrinsics lens{500, 500, 0, 0};
  lens.k1 = -1;
  lens.k2 = 0.42;
  const CameraModel camera(lens);
  EXPECT_TRUE(camera.project({std::sqrt(0.52), 0, 1}));
  EXPECT_FALSE(camera.project({std::sqrt(0.54), 0, 1}));
  EXPECT_FALSE(camera.project({1.2, 0, 1}));
}

TEST(CameraModel, APixelThatIsNoNumberHasNoRay) {
  const CameraModel camera(CameraIntrinsics{});
  EXPECT_FALSE(camera.ray({std::numeric_limits<double>::quiet_NaN(), 0}));
  EXPECT_FALSE(camera.ray({0, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(camera.ray({1e300, 0}));
}

TEST(CameraModel, RefusesIntrinsicsThatAreNoCamera) {
  CameraIntrinsics lens;
  lens.fy_px = 0;
  EXPECT_THROW(CameraModel{lens}, std::invalid_argument);
  lens = {};
  lens.k2 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(CameraModel{lens}, std::invalid_argument);
}

}  // namespace
}  // namespace aisle
