#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "aisle/vision/stripes/stripe_scan.hpp"
#include "lit_floor.hpp"

namespace aisle {
namespace {

const CameraIntrinsics kFanLens{.fx_px = 460, .fy_px = 460, .cx_px = 319.5, .cy_px = 239.5, .k1 = -0.18};
const Vec2 kLensFloorPoint{0.85, 0};

StripeScan stripe_scan() {
  return {{}, kFanLens, kMount, kWidth_px, kHeight_px, kLightHeight_m};
}

/// Laser light on a wall from one point to another, seen from above: a line three rows thick.
/// @param contrast_m2  brightness over the floor's, times the squared distance
void shine_on(Image& image, const Vec2& from, const Vec2& to, double contrast_m2 = 400) {
  const CameraModel camera(kFanLens);
  constexpr int kSteps = 4000;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec2 p = from + (to - from) * i / kSteps;
    const auto pixel = camera.project(kMount.to_camera({p.x(), p.y(), kLightHeight_m}));
    if (!pixel) continue;
    const int u = static_cast<int>(std::lround(pixel->x()));
    if (u < 0 || u >= kWidth_px) continue;
    const double light = std::min(120.0, contrast_m2 / (p - kLensFloorPoint).squaredNorm());
    for (int v = static_cast<int>(std::floor(pixel->y())) - 1; v <= pixel->y() + 2; ++v) {
      if (v < 0 || v >= kHeight_px) continue;
      const double share = std::max(0.0, 1 - std::abs(v - pixel->y()) / 2);
      auto& level = image.row(v)[u];
      level = std::max(level, static_cast<std::uint8_t>(kFloorLevel + share * light));
    }
  }
}

const StripeScan::Beam& beam_at(const StripeScan& eye, double angle_deg) {
  const double beam = (angle_deg * kDegree - eye.first_angle_rad()) / StripeScan::angle_step_rad();
  return eye.beams().at(static_cast<std::size_t>(std::lround(beam)));
}

TEST(StripeScan, TellsHowFarAwayAWallStands) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  shine_on(image, {2.85, -3}, {2.85, 3});
  eye.find(image);
  for (double angle_deg = -35; angle_deg <= 35; angle_deg += 2.5)
    EXPECT_NEAR(beam_at(eye, angle_deg).range_m, 2 / std::cos(angle_deg * kDegree), 0.01) << angle_deg;
}

TEST(StripeScan, SeesWallsBesideTheRoute) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  for (const double side_m : {-0.5, 1.0}) shine_on(image, {0.9, side_m}, {4, side_m}, 200);
  eye.find(image);
  EXPECT_NEAR(beam_at(eye, 25).range_m, 1.0 / std::sin(25 * kDegree), 0.02);
  EXPECT_NEAR(beam_at(eye, 35).range_m, 1.0 / std::sin(35 * kDegree), 0.02);
  EXPECT_NEAR(beam_at(eye, -15).range_m, 0.5 / std::sin(15 * kDegree), 0.02);
  EXPECT_NEAR(beam_at(eye, -25).range_m, 0.5 / std::sin(25 * kDegree), 0.02);
}

TEST(StripeScan, SeesTheLegOfAChair) {
  for (const double ahead_m : {1.8, 2.5}) {
    StripeScan eye = stripe_scan();
    Image image = floor_with_noise();
    shine_on(image, {ahead_m, -0.02}, {ahead_m, 0.02});
    eye.find(image);
    EXPECT_NEAR(beam_at(eye, 0).range_m, ahead_m - kLensFloorPoint.x(), 0.01) << ahead_m;
    EXPECT_EQ(beam_at(eye, 5).range_m, 0) << ahead_m;
  }
}

TEST(StripeScan, TakesNeitherNoiseNorTheJointsOfTilesForLight) {
  Image image = floor_with_noise();
  const BackProjection floor(CameraModel(kFanLens), kMount, 0);
  const auto is_joint = [](double p_m) { return std::abs(std::remainder(p_m, 0.3)) < 0.003; };
  for (int v = 150; v < kHeight_px; ++v) {
    for (int u = 0; u < kWidth_px; ++u) {
      const auto p = floor.point({u, v});
      if (p && (is_joint(p->x()) || is_joint(p->y()))) image.row(v)[u] = 80;
    }
  }
  StripeScan eye = stripe_scan();
  eye.find(image);
  for (const StripeScan::Beam& beam : eye.beams()) EXPECT_TRUE(beam.range_m == 0 || beam.range_m > 4);
  EXPECT_FALSE(eye.sees_light());
}

TEST(StripeScan, TakesNoPaperOnTheFloorNearbyForLight) {
  StripeScan eye = stripe_scan();
  for (double away_m = 1.3; away_m < 3; away_m += 0.5) {
    for (const double turned_deg : {0.0, 20.0, 45.0}) {
      Image image = floor_with_noise();
      lay_paper(image, kFanLens, {0.85 + away_m, 0}, turned_deg * kDegree);
      eye.find(image);
      for (const StripeScan::Beam& beam : eye.beams())
        ASSERT_EQ(beam.range_m, 0) << away_m << " m, " << turned_deg << " degrees";
    }
  }
}

/// Between smooth walls; the farther away its tufts, the less they differ.
Image carpet(std::uint64_t seed) {
  constexpr double kTuft_m = 0.01, kDiffer_m = 10, kHalfWidth_m = 0.6;
  constexpr unsigned kTufts = 512;
  Random random(seed);
  std::vector<double> tufts(kTufts * kTufts);
  for (double& tuft : tufts) tuft = random.normal(1);
  Image image = floor_with_noise();
  const BackProjection floor(CameraModel(kFanLens), kMount, 0);
  for (int v = 150; v < kHeight_px; ++v) {
    for (int u = 0; u < kWidth_px; ++u) {
      const auto p = floor.point({u, v});
      if (!p || std::abs(p->y()) > kHalfWidth_m) continue;
      const auto cell = [](double p_m) { return static_cast<unsigned>(std::lround(p_m / kTuft_m)) % kTufts; };
      const double tuft = tufts[cell(p->x()) * kTufts + cell(p->y())];
      image.row(v)[u] = static_cast<std::uint8_t>(
          std::lround(image.row(v)[u] + kDiffer_m * tuft / std::max(0.8, p->norm() - kLensFloorPoint.x())));
    }
  }
  return image;
}

TEST(StripeScan, TakesNoGrainOfACarpetForLight) {
  StripeScan eye = stripe_scan();
  int lit = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    eye.find(carpet(seed));
    for (const StripeScan::Beam& beam : eye.beams()) lit += beam.range_m > 0 ? 1 : 0;
  }
  EXPECT_EQ(lit, 0);
}

TEST(StripeScan, SeesTheLegOfAChairOnACarpet) {
  StripeScan eye = stripe_scan();
  Image image = carpet(1);
  shine_on(image, {2.2, -0.02}, {2.2, 0.02}, 100);
  eye.find(image);
  EXPECT_NEAR(beam_at(eye, 0).range_m, 2.2 - kLensFloorPoint.x(), 0.01);
}

TEST(StripeScan, TakesTheFaintStripeBeforeABrightOneForItsMirrorImage) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  shine_on(image, {3.35, -3}, {3.35, 3}, 500);
  shine_on(image, {2.2, -1}, {2.2, 1}, 40);
  eye.find(image);
  EXPECT_NEAR(beam_at(eye, 0).range_m, 2.5, 0.02);
}

TEST(StripeScan, GivesTheLaserReturns) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  shine_on(image, {2.5, -0.3}, {2.5, 0.1});
  eye.find(image);
  std::vector<Vec2> p_vehicle_returns;
  eye.append_lit(p_vehicle_returns);
  ASSERT_FALSE(p_vehicle_returns.empty());
  for (const Vec2& p_vehicle : p_vehicle_returns) EXPECT_NEAR(p_vehicle.x(), 2.5, 0.01);
  EXPECT_NEAR(p_vehicle_returns.front().y(), -0.3, 0.015);
  EXPECT_NEAR(p_vehicle_returns.back().y(), 0.1, 0.015);
}

TEST(StripeScan, SaysWhereTheFloorIsFreeAndWhereItCannotKnow) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  shine_on(image, {2.5, -0.3}, {2.5, 0.3});
  eye.find(image);
  EXPECT_TRUE(eye.is_free({2, 0}));
  EXPECT_FALSE(eye.is_free({2.5, 0}));
  EXPECT_FALSE(eye.is_free({3, 0})) << "hidden";
  EXPECT_TRUE(eye.is_free({3, 0.8}));
  EXPECT_FALSE(eye.is_free({1.2, 0})) << "below the image";
  EXPECT_FALSE(eye.is_free({2, 3})) << "out of view";
  EXPECT_FALSE(eye.is_free({-1, 0})) << "behind";
  EXPECT_FALSE(eye.is_free({6, 0})) << "out of reach";
  eye.find(floor_with_noise());
  EXPECT_FALSE(eye.is_free({2, 0})) << "no light";
}

TEST(StripeScan, AWallThatFadesOutMayGoOn) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  shine_on(image, {0.9, 0.5}, {2.85, 0.5}, 60);
  eye.find(image);
  ASSERT_GT(beam_at(eye, 16).range_m, 1.5);
  EXPECT_EQ(beam_at(eye, 12).range_m, 0);
  EXPECT_TRUE(beam_at(eye, 12).may_be_shut);
  EXPECT_FALSE(beam_at(eye, 0).may_be_shut);
}

TEST(StripeScan, AWallThatEndsInFullLightHasEnded) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  shine_on(image, {0.9, 0.5}, {2.85, 0.5}, 400);
  eye.find(image);
  EXPECT_EQ(beam_at(eye, 12).range_m, 0);
  EXPECT_FALSE(beam_at(eye, 12).may_be_shut);
}

TEST(StripeScan, AWallThatLeavesTheImageBelowShutsTheBeamsBeyond) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  shine_on(image, {1.1, -0.8}, {2.6, 0.7}, 300);
  eye.find(image);
  ASSERT_GT(beam_at(eye, 15).range_m, 0);
  EXPECT_EQ(beam_at(eye, -25).range_m, 0);
  EXPECT_TRUE(beam_at(eye, -25).may_be_shut);
}

TEST(StripeScan, LooksOnlyWhereTheImageShowsTheLightPlane) {
  const StripeScan eye = stripe_scan();
  EXPECT_DOUBLE_EQ(eye.first_angle_rad(),
                   -static_cast<double>(eye.beams().size() - 1) / 2 * StripeScan::angle_step_rad());
  const BackProjection plane(CameraModel(kFanLens), kMount, kLightHeight_m);
  const double lowest_m = plane.point({319.5, kHeight_px - 1})->x() - kLensFloorPoint.x();
  EXPECT_GT(beam_at(eye, 0).near_m, lowest_m);
  EXPECT_LT(beam_at(eye, 0).near_m, lowest_m + 0.1);
  EXPECT_GT(beam_at(eye, 0).far_m, 6);
}

TEST(StripeScan, NoticesThatTheLasersAreOffByTheWallsFarAway) {
  StripeScan eye = stripe_scan();
  Image image = floor_with_noise();
  eye.find(image);
  EXPECT_FALSE(eye.sees_light());
  shine_on(image, {6.85, -1}, {6.85, 1}, 2000);
  eye.find(image);
  EXPECT_TRUE(eye.sees_light());
}

TEST(StripeScan, RefusesImagesAndCamerasThatDoNotFit) {
  StripeScan eye = stripe_scan();
  EXPECT_THROW(eye.find(Image(320, 240)), std::invalid_argument);
  EXPECT_THROW(eye.find(Image(kWidth_px, kHeight_px, 3)), std::invalid_argument);
  CameraMount up = kMount;
  up.tilt_rad = -60 * kDegree;
  EXPECT_THROW(StripeScan({}, kFanLens, up, kWidth_px, kHeight_px, kLightHeight_m), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
