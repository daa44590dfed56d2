/// The camera model against OpenCV's functions for the same lens.

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {
namespace {

const cv::Vec3d kNone(0, 0, 0);

cv::Matx33d matrix_of(const CameraIntrinsics& lens) {
  return {lens.fx_px, 0, lens.cx_px, 0, lens.fy_px, lens.cy_px, 0, 0, 1};
}

std::vector<cv::Point3d> points_in_front(Random& random, double slope_max) {
  std::vector<cv::Point3d> points;
  for (int i = 0; i < 100; ++i) {
    const double z = random.uniform(0.5, 10);
    points.emplace_back(z * random.uniform(-slope_max, slope_max), z * random.uniform(-slope_max, slope_max),
                        z);
  }
  return points;
}

void expect_same(const CameraIntrinsics& lens, const std::vector<cv::Point3d>& points,
                 const std::vector<cv::Point2d>& expected) {
  const CameraModel camera(lens);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto pixel = camera.project({points[i].x, points[i].y, points[i].z});
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), expected[i].x, 1e-9);
    EXPECT_NEAR(pixel->y(), expected[i].y, 1e-9);
    const auto ray = camera.ray({expected[i].x, expected[i].y});
    ASSERT_TRUE(ray);
    EXPECT_NEAR(ray->direction.x(), points[i].x / points[i].z, 1e-9);
    EXPECT_NEAR(ray->direction.y(), points[i].y / points[i].z, 1e-9);
  }
}

TEST(LensModels, PlumbBobAndRationalAgreeWithProjectPoints) {
  CameraIntrinsics lens{532.8, 532.9, 342.5, 233.9, -0.28, 0.025, 0.0012, -0.00014, 0.16};
  Random random(1);
  const auto points = points_in_front(random, 0.45);
  std::vector<cv::Point2d> expected;
  cv::projectPoints(points, kNone, kNone, matrix_of(lens),
                    std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}, expected);
  expect_same(lens, points, expected);
  lens.model = LensModel::kRationalPolynomial;
  lens.k4 = 0.1, lens.k5 = -0.02, lens.k6 = 0.03;
  cv::projectPoints(
      points, kNone, kNone, matrix_of(lens),
      std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, lens.k4, lens.k5, lens.k6}, expected);
  expect_same(lens, points, expected);
}

TEST(LensModels, EquidistantAgreesWithTheFisheyeFunctions) {
  CameraIntrinsics lens{290.8, 291.2, 321.5, 238.9, 0.0175653, -0.0031772};
  lens.model = LensModel::kEquidistant;
  lens.k3 = 0.000362, lens.k4 = -0.000719;
  Random random(2);
  const auto points = points_in_front(random, 2.5);
  std::vector<cv::Point2d> expected;
  cv::fisheye::projectPoints(points, expected, cv::Affine3d::Identity(), matrix_of(lens),
                             cv::Vec4d(lens.k1, lens.k2, lens.k3, lens.k4));
  expect_same(lens, points, expected);
}

}  // namespace
}  // namespace aisle
