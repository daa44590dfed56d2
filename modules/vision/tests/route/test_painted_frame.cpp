#include "aisle/vision/route/painted_frame.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "seen_floor.hpp"

namespace aisle {
namespace {

const Vec2 kSize_m(1.64, 1.14);

/// Points on the sides of a rectangle, with noise, and others that belong to nothing.
std::vector<Vec2> points_on(const Pose2& T_vehicle_frame, double noise_m, Random& random) {
  std::vector<Vec2> points;
  for (int i = 0; i < 300; ++i) {
    const double x = random.uniform(-0.5, 0.5) * kSize_m.x(), y = random.uniform(-0.5, 0.5) * kSize_m.y();
    const double side = random.index(2) == 0 ? -0.5 : 0.5;
    const Vec2 p = random.index(2) == 0 ? Vec2(side * kSize_m.x(), y) : Vec2(x, side * kSize_m.y());
    points.push_back(T_vehicle_frame * Vec2(p.x() + random.normal(noise_m), p.y() + random.normal(noise_m)));
  }
  for (int i = 0; i < 60; ++i) points.emplace_back(random.uniform(0, 4), random.uniform(-2, 2));
  return points;
}

RC_GTEST_PROP(PaintedFrame, IsFoundWhereverItLiesAmongOtherPoints, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 T_vehicle_frame{random.uniform(1.5, 3.5), random.uniform(-0.8, 0.8), random.uniform(-0.4, 0.4)};
  const auto fit = find_frame(points_on(T_vehicle_frame, 0.005, random), kSize_m, 0, {});
  RC_ASSERT(fit.has_value());
  const Pose2 off = between(T_vehicle_frame, fit->T_vehicle_frame);
  RC_ASSERT(off.position().norm() < 0.01);
  RC_ASSERT(std::abs(off.theta) < 0.6 * kDegree);
}

TEST(PaintedFrame, TheCornersGoRoundFromTheFarLeft) {
  const FrameFit fit{.T_vehicle_frame = {2, 0, kPi / 2}, .size_m = {2, 1}};
  const auto corners = fit.corners();
  EXPECT_NEAR((corners[0] - Vec2(1.5, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((corners[2] - Vec2(2.5, -1)).norm(), 0, 1e-12);
}

TEST(PaintedFrame, TwoSidesOfOneDirectionDoNotTellWhereItIs) {
  Random random(1);
  std::vector<Vec2> points;
  for (int i = 0; i < 100; ++i) points.emplace_back(random.uniform(1.2, 2.8), i % 2 == 0 ? 0.57 : -0.57);
  EXPECT_FALSE(track_frame(points, kSize_m, {2, 0, 0}, {}));
  EXPECT_FALSE(find_frame(points, kSize_m, 0, {}));
}

TEST(PaintedFrame, ASideWithACornerTellsWhereItIsAndASideAloneDoesNot) {
  const Pose2 T_vehicle_frame{1, 0.03, 1 * kDegree};
  std::vector<Vec2> points;
  for (int i = 0; i <= 100; ++i)
    points.push_back(T_vehicle_frame * Vec2(-kSize_m.x() / 2, (i / 100.0 - 0.5) * 0.9 * kSize_m.y()));
  EXPECT_FALSE(track_frame(points, kSize_m, {1, 0, 0}, {}));
  for (int i = 0; i <= 10; ++i)
    points.push_back(T_vehicle_frame * Vec2(-kSize_m.x() / 2 + 0.02 + 0.004 * i, kSize_m.y() / 2));
  const auto fit = track_frame(points, kSize_m, {1, 0, 0}, {});
  ASSERT_TRUE(fit);
  const Pose2 off = between(T_vehicle_frame, fit->T_vehicle_frame);
  EXPECT_LT(off.position().norm(), 0.01);
  EXPECT_LT(std::abs(off.theta), 0.5 * kDegree);
}

TEST(PaintedFrame, AnImageShowsItsSizeAndPlace) {
  const Pose2 T_vehicle_frame{2.75, 0.1, 8 * kDegree};
  const Image image = seen_floor([&](const Vec2& p_vehicle) {
    const Vec2 p = T_vehicle_frame.inverse() * p_vehicle;
    const double off_m = (p.cwiseAbs() - kSize_m / 2).maxCoeff();
    return std::abs(off_m) < 0.03 ? 210.0 : 160.0;
  });
  const auto points = painted_line_points(image, floor_lens(), floor_mount(), {});
  const auto fit = find_frame_and_size(points, 0, {});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->size_m.x(), kSize_m.x(), 0.02);
  EXPECT_NEAR(fit->size_m.y(), kSize_m.y(), 0.02);
  const Pose2 off = between(T_vehicle_frame, fit->T_vehicle_frame);
  EXPECT_LT(off.position().norm(), 0.015);
  EXPECT_LT(std::abs(off.theta), 0.5 * kDegree);
}

TEST(PaintedFrame, APlainFloorHasNone) {
  const Image image = seen_floor([](const Vec2&) { return 160.0; });
  EXPECT_FALSE(find_frame(painted_line_points(image, floor_lens(), floor_mount(), {}), kSize_m, 0, {}));
}

}  // namespace
}  // namespace aisle
