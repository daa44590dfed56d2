#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

const CameraModel kCamera(CameraIntrinsics{500, 500, 320, 240});

CameraMount level_mount(double height_m, double tilt_rad = 0) {
  CameraMount mount;
  mount.p_vehicle_camera.z() = height_m;
  mount.tilt_rad = tilt_rad;
  return mount;
}

CameraMount any_mount(Random& random) {
  return {{random.uniform(-1, 1), random.uniform(-0.5, 0.5), random.uniform(0.2, 1.5)},
          random.uniform(0.1, 0.7),
          random.uniform(-kPi, kPi),
          random.uniform(-0.2, 0.2)};
}

CameraModel any_camera(Random& random) {
  CameraIntrinsics lens{500, 510, 318, 242};
  lens.k1 = random.uniform(-0.3, 0.3);
  lens.k2 = random.uniform(-0.05, 0.05);
  lens.p1 = random.uniform(-0.005, 0.005);
  lens.p2 = random.uniform(-0.005, 0.005);
  return CameraModel(lens);
}

/// A pixel in the lower part of a 640 x 480 image, where the floor is.
Vec2 any_floor_pixel(Random& random) {
  return {random.uniform(60, 580), random.uniform(260, 470)};
}

TEST(CameraMount, LevelAndAheadByHand) {
  const CameraMount mount = level_mount(1);
  EXPECT_LT((mount.to_camera({3, 0, 1}) - Vec3(0, 0, 3)).norm(), 1e-12);
  EXPECT_LT((mount.to_camera({3, -1, 1}) - Vec3(1, 0, 3)).norm(), 1e-12);     // to the right
  EXPECT_LT((mount.to_camera({3, 0, 0.5}) - Vec3(0, 0.5, 3)).norm(), 1e-12);  // below
}

TEST(CameraMount, SignsOfTiltPanAndRoll) {
  const Vec3 axis = Vec3::UnitZ(), right = Vec3::UnitX();
  CameraMount mount;
  mount.tilt_rad = 0.1;
  EXPECT_LT((mount.R_vehicle_camera() * axis).z(), 0);  // looks down
  mount = {};
  mount.pan_rad = 0.1;
  EXPECT_GT((mount.R_vehicle_camera() * axis).y(), 0);  // looks to the left
  mount = {};
  mount.roll_rad = 0.1;
  EXPECT_LT((mount.R_vehicle_camera() * right).z(), 0);  // leans to the right
}

TEST(BackProjection, FloorPointsByHand) {
  const BackProjection floor(kCamera, level_mount(1), 0);
  EXPECT_THAT(*floor.point({320, 490}), PointNear(Vec2(2, 0), 1e-12));   // 1 down on 2 ahead
  EXPECT_THAT(*floor.point({570, 490}), PointNear(Vec2(2, -1), 1e-12));  // right of the axis is negative y
  const BackProjection tilted(kCamera, level_mount(1, 45 * kDegree), 0);
  EXPECT_THAT(*tilted.point({320, 240}), PointNear(Vec2(1, 0), 1e-12));
}

TEST(BackProjection, MountedToTheLeftAndAheadTheOffsetAdds) {
  CameraMount mount = level_mount(1);
  mount.p_vehicle_camera = {0.3, 0.1, 1};
  mount.pan_rad = kPi / 2;
  EXPECT_THAT(*BackProjection(kCamera, mount, 0).point({320, 490}), PointNear(Vec2(0.3, 2.1), 1e-12));
}

TEST(BackProjection, ALaserStripeIsNearerThanTheFloorBelowIt) {
  EXPECT_THAT(*BackProjection(kCamera, level_mount(1), 0.5).point({320, 490}), PointNear(Vec2(1, 0), 1e-12));
}

TEST(BackProjection, AtOrAboveTheHorizonThereIsNoPoint) {
  const BackProjection floor(kCamera, level_mount(1), 0);
  EXPECT_FALSE(floor.point({320, 240}));
  EXPECT_FALSE(floor.point({10, 240}));
  EXPECT_FALSE(floor.point({320, 100}));
  EXPECT_FALSE(floor.uncertain_point({320, 240}, {}));
  EXPECT_FALSE(floor.uncertain_point({320, 100}, {}));
}

TEST(BackProjection, APlaneAboveTheLensIsSeenAboveTheHorizon) {
  const BackProjection ceiling(kCamera, level_mount(1), 2);
  EXPECT_THAT(*ceiling.point({320, -10}), PointNear(Vec2(2, 0), 1e-12));
  EXPECT_FALSE(ceiling.point({320, 490}));
}

TEST(BackProjection, APlaneThroughTheLensHasNoPoints) {
  EXPECT_FALSE(BackProjection(kCamera, level_mount(1), 1).point({320, 300}));
}

TEST(BackProjection, CloseToTheHorizonThereIsAPointButNoCovariance) {
  const BackProjection floor(kCamera, level_mount(1), 0);
  const BackProjectionNoise half_a_pixel{0.5, 0};
  EXPECT_TRUE(floor.point({320, 241}));
  EXPECT_FALSE(floor.uncertain_point({320, 241.4}, half_a_pixel));
  EXPECT_TRUE(floor.uncertain_point({320, 241.6}, half_a_pixel));
}

RC_GTEST_PROP(BackProjection, UndoesProjectionOfAPointOnThePlane, (std::uint64_t seed)) {
  Random random(seed);
  const CameraModel camera = any_camera(random);
  const CameraMount mount = any_mount(random);
  const double height_m = random.uniform(0, 0.15);
  const BackProjection plane(camera, mount, height_m);
  const Vec2 pixel = any_floor_pixel(random);
  const auto point = plane.point(pixel);
  RC_PRE(point.has_value());
  const auto again = camera.project(mount.to_camera({point->x(), point->y(), height_m}));
  RC_ASSERT(again.has_value());
  RC_ASSERT((*again - pixel).norm() < 1e-7);
}

RC_GTEST_PROP(BackProjection, CovarianceMatchesNumericalDifferences, (std::uint64_t seed)) {
  Random random(seed);
  const CameraModel camera = any_camera(random);
  const CameraMount mount = any_mount(random);
  const Vec2 pixel = any_floor_pixel(random);
  const BackProjectionNoise noise{random.uniform(0, 1), random.uniform(0, 0.01)};
  const auto point = BackProjection(camera, mount, 0).uncertain_point(pixel, noise);
  RC_PRE(point.has_value());

  const auto point_at = [&](const Vec3& nudge) {
    CameraMount nudged = mount;
    nudged.tilt_rad += nudge.z();
    return *BackProjection(camera, nudged, 0).point(pixel + nudge.head<2>());
  };
  const Vec3 steps{1e-3, 1e-3, 1e-6}, sigmas{noise.pixel_px, noise.pixel_px, noise.tilt_rad};
  Mat2 numerical = Mat2::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 nudge = steps[i] * Vec3::Unit(i);
    const Vec2 error = (point_at(nudge) - point_at(-nudge)) / (2 * steps[i]) * sigmas[i];
    numerical += error * error.transpose();
  }
  RC_ASSERT((point->covariance - numerical).norm() < 1e-4 * numerical.norm());
}

TEST(BackProjection, CovarianceMatchesASeededMonteCarlo) {
  CameraMount mount = level_mount(1, 20 * kDegree);
  mount.pan_rad = 0.4;
  const BackProjectionNoise noise{0.5, 0.2 * kDegree};
  const Vec2 pixel{450, 300};
  const auto predicted = BackProjection(kCamera, mount, 0).uncertain_point(pixel, noise);
  ASSERT_TRUE(predicted);
  Random random(5);
  Mat2 sampled = Mat2::Zero();
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    CameraMount shaken = mount;
    shaken.tilt_rad += random.normal(noise.tilt_rad);
    const Vec2 seen = pixel + Vec2(random.normal(noise.pixel_px), random.normal(noise.pixel_px));
    const Vec2 off = *BackProjection(kCamera, shaken, 0).point(seen) - predicted->mean;
    sampled += off * off.transpose() / kDraws;
  }
  EXPECT_LT((sampled - predicted->covariance).norm(), 0.03 * predicted->covariance.norm());
}

/// The pixel of a floor point straight ahead, for a level camera 1 m above the floor.
Vec2 pixel_of_floor_ahead(double distance_m) {
  return *kCamera.project(level_mount(1).to_camera({distance_m, 0, 0}));
}

TEST(BackProjection, TheSamePixelErrorIsWorseFartherAway) {  // C98 Fig. 4
  const BackProjection floor(kCamera, level_mount(1), 0);
  double last_m = 0;
  for (double distance_m : {2.0, 4.0, 8.0, 16.0}) {
    const auto point = floor.uncertain_point(pixel_of_floor_ahead(distance_m), {0.5, 0});
    ASSERT_TRUE(point) << distance_m;
    const double along_m = std::sqrt(point->covariance(0, 0)), across_m = std::sqrt(point->covariance(1, 1));
    EXPECT_NEAR(along_m, 0.5 / 500 * distance_m * distance_m, 1e-9);
    EXPECT_NEAR(across_m, 0.5 / 500 * distance_m, 1e-9);
    EXPECT_GT(along_m, last_m);
    last_m = along_m;
  }
}

TEST(BackProjection, TheSameTiltErrorMovesTheRayInProportionToTheDistance) {  // C98 eq. (4), Fig. 5
  const BackProjection floor(kCamera, level_mount(1), 0);
  constexpr double kTilt = 0.1 * kDegree;
  double last_m = 0;
  for (double distance_m : {2.0, 4.0, 8.0, 16.0}) {
    const auto point = floor.uncertain_point(pixel_of_floor_ahead(distance_m), {0, kTilt});
    ASSERT_TRUE(point) << distance_m;
    const double sight_m = std::hypot(distance_m, 1), along_m = std::sqrt(point->covariance(0, 0));
    EXPECT_NEAR(along_m * (1 / sight_m), sight_m * kTilt, 1e-9);  // seen from the lens: s theta
    EXPECT_NEAR(point->covariance(1, 1), 0, 1e-12);
    EXPECT_GT(along_m, last_m);
    last_m = along_m;
  }
}

}  // namespace
}  // namespace aisle
