#include "aisle/calibration/laser_calibration.hpp"

#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"

namespace aisle {
namespace {

using testing::Contains;
using testing::HasSubstr;

const CameraModel kLens({500, 505, 320, 240, -0.2, 0.05, 0, 0, 0});
const CameraMount kMount{{0.4, 0.05, 1.1}, 12 * kDegree, 2 * kDegree, 1 * kDegree};

/// The stripe of the plane z = height + ahead x + left y on a wall at right angles to x.
StripeView stripe_on_wall(double distance_m, double height_m, double ahead, double left, double noise_px,
                          Random& random) {
  StripeView view{wall_ahead(distance_m), {}};
  for (double y_m = -0.5; y_m < 0.5; y_m += 0.01) {
    const Vec3 p{distance_m, y_m, height_m + ahead * distance_m + left * y_m};
    const auto pixel = kLens.project(kMount.to_camera(p));
    if (pixel) view.points_px.push_back(*pixel + Vec2(0, random.normal(noise_px)));
  }
  return view;
}

TEST(LaserCalibration, TheHeightComesBackWithinItsDeviation) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    std::vector<StripeView> views;
    for (const double d : {1.5, 2.0, 3.0}) views.push_back(stripe_on_wall(d, 0.3, 0, 0, 0.3, random));
    const auto found = calibrate_laser(views, kLens, kMount);
    ASSERT_TRUE(found);
    EXPECT_LT(std::abs(found->height_m - 0.3), 4 * found->height_deviation_m) << seed;
    EXPECT_LT(std::abs(found->height_m - 0.3), 0.002) << seed;
    EXPECT_NEAR(found->rms_px, 0.3, 0.05);
    EXPECT_EQ(found->verdict.quality, CalibrationQuality::kGood);
  }
}

TEST(LaserCalibration, AStripeAmidOtherBrightThingsIsFound) {
  Random random(1);
  std::vector<StripeView> views{stripe_on_wall(2, 0.3, 0, 0, 0.3, random)};
  for (int i = 0; i < 30; ++i) {
    views[0].points_px.emplace_back(random.uniform(0, 639), random.uniform(100, 479));
  }
  const auto found = calibrate_laser(views, kLens, kMount);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->height_m, 0.3, 0.002);
}

TEST(LaserCalibration, APlaneThatIsNotLevelIsMeasuredAndWarnedOf) {
  Random random(2);
  std::vector<StripeView> views;
  for (const double d : {1.5, 2.5, 4.0}) views.push_back(stripe_on_wall(d, 0.3, 0.02, -0.01, 0.1, random));
  const auto found = calibrate_laser(views, kLens, kMount);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->height_m, 0.3, 0.003);
  EXPECT_NEAR(found->slope_ahead, 0.02, 0.001);
  EXPECT_NEAR(found->slope_left, -0.01, 0.001);
  EXPECT_EQ(found->verdict.quality, CalibrationQuality::kUsable);
  EXPECT_THAT(found->verdict.reasons, Contains(HasSubstr("not level")));
}

TEST(LaserCalibration, OneDistanceTellsNothingOfTheSlopeAhead) {
  Random random(3);
  const std::vector<StripeView> views{stripe_on_wall(2, 0.3, 0, 0, 0.1, random)};
  const auto found = calibrate_laser(views, kLens, kMount);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->slope_ahead, 0);
  EXPECT_EQ(found->slope_ahead_deviation, 0);
  EXPECT_NEAR(found->slope_left, 0, 0.002);
}

TEST(LaserCalibration, APlaneSeenFromTheCameraIsTheSameWall) {
  const Vec3 p_wall{2.5, 0.7, 0.9};
  const Vec3 normal_camera = kMount.R_vehicle_camera().transpose() * Vec3::UnitX();
  const TargetPlane plane = plane_seen(kMount, kMount.to_camera(p_wall), normal_camera);
  EXPECT_LT((plane.normal - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_NEAR(plane.offset_m, 2.5, 1e-12);
}

TEST(LaserCalibration, ScatteredPointsGiveNoHeight) {
  Random random(4);
  StripeView view{wall_ahead(2), {}};
  for (int i = 0; i < 10; ++i) view.points_px.emplace_back(random.uniform(0, 639), random.uniform(0, 479));
  EXPECT_FALSE(calibrate_laser(std::vector<StripeView>{view}, kLens, kMount));
  EXPECT_FALSE(calibrate_laser(std::vector<StripeView>{}, kLens, kMount));
}

}  // namespace
}  // namespace aisle
