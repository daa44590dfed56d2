#include <gmock/gmock.h>

#include "aisle/vision/stripe_probe.hpp"
#include "lit_floor.hpp"

namespace aisle {
namespace {

const CameraIntrinsics kProbeLens{.fx_px = 460, .fy_px = 460, .cx_px = 319.5, .cy_px = 239.5};

Vec2 pixel_of(const Vec3& p_vehicle) {
  return *CameraModel(kProbeLens).project(kMount.to_camera(p_vehicle));
}

/// Laser light on something that faces the vehicle; three rows thick.
void shine_on(Image& picture, double ahead_m, double right_m, double left_m) {
  const int v = static_cast<int>(std::lround(pixel_of({ahead_m, 0, kLightHeight_m}).y()));
  const auto column = [&](double y_m) {
    return static_cast<int>(std::lround(pixel_of({ahead_m, y_m, kLightHeight_m}).x()));
  };
  for (int u = column(left_m); u <= column(right_m); ++u) {
    picture.row(v - 1)[u] = picture.row(v + 1)[u] = 170;
    picture.row(v)[u] = 220;
  }
}

StripeProbe probe() {
  return {{}, kProbeLens, kMount, kWidth_px, kHeight_px, kLightHeight_m};
}

TEST(StripeProbe, SeesWhereAThingStands) {
  StripeProbe eye = probe();
  Image picture = floor_with_noise();
  shine_on(picture, 2.5, -0.3, 0.1);
  const auto& lit = eye.find(picture);
  ASSERT_FALSE(lit.empty());
  for (const Vec2& p_vehicle : lit) EXPECT_NEAR(p_vehicle.x(), 2.5, 0.02);
  EXPECT_NEAR(lit.front().y(), 0.1, 0.01);
  EXPECT_NEAR(lit.back().y(), -0.3, 0.01);
}

TEST(StripeProbe, SeesTheLegOfAChairFromTheDistanceThatItTakesToStop) {
  for (double away_m : {0.9, 1.2, 1.5}) {
    StripeProbe eye = probe();
    Image picture = floor_with_noise();
    shine_on(picture, 0.85 + away_m, -0.015, 0.015);
    EXPECT_FALSE(eye.find(picture).empty()) << away_m;
  }
}

TEST(StripeProbe, TakesNeitherNoiseNorPaperForLight) {
  StripeProbe eye = probe();
  EXPECT_TRUE(eye.find(floor_with_noise()).empty());
  for (double away_m = 1.3; away_m < 5; away_m += 0.2) {
    for (double turned_deg : {0.0, 20.0, 45.0}) {
      Image picture = floor_with_noise();
      lay_paper(picture, kProbeLens, {0.85 + away_m, 0}, turned_deg * kDegree);
      EXPECT_TRUE(eye.find(picture).empty()) << away_m << " m, " << turned_deg << " degrees";
    }
  }
}

TEST(StripeProbe, TakesTheFaintStripeBelowABrightOneForItsMirrorImage) {
  StripeProbe eye = probe();
  Image picture = floor_with_noise();
  shine_on(picture, 2.8, -0.3, 0.3);
  const int v = static_cast<int>(pixel_of({2.8, 0, -kLightHeight_m}).y());
  for (int u = 300; u < 340; ++u) picture.row(v)[u] = 160;
  for (const Vec2& p_vehicle : eye.find(picture)) EXPECT_NEAR(p_vehicle.x(), 2.8, 0.03);
}

TEST(StripeProbe, SaysWhereTheWayIsFreeAndWhereItCannotKnow) {
  StripeProbe eye = probe();
  Image picture = floor_with_noise();
  shine_on(picture, 2.5, -0.3, 0.3);
  eye.find(picture);
  using Sight = StripeProbe::Seen;
  EXPECT_EQ(eye.seen_at({2, 0}), Sight::kFree);
  EXPECT_EQ(eye.seen_at({2.5, 0}), Sight::kNothing);
  EXPECT_EQ(eye.seen_at({3, 0}), Sight::kNothing);
  EXPECT_EQ(eye.seen_at({3, 0.8}), Sight::kFree);
  EXPECT_EQ(eye.seen_at({1.2, 0}), Sight::kNothing);  // below the picture
  EXPECT_EQ(eye.seen_at({2, 3}), Sight::kNothing);    // out of view
  EXPECT_EQ(eye.seen_at({6, 0}), Sight::kNothing);    // out of reach
}

TEST(StripeProbe, NoticesThatTheMarkersAreOffByTheWallsFarAway) {
  StripeProbe eye = probe();
  Image picture = floor_with_noise();
  eye.find(picture);
  EXPECT_FALSE(eye.sees_light());
  shine_on(picture, 6, -1, 1);
  EXPECT_TRUE(eye.find(picture).empty());
  EXPECT_TRUE(eye.sees_light());
}

TEST(StripeProbe, RefusesPicturesAndCamerasThatDoNotFit) {
  StripeProbe eye = probe();
  EXPECT_THROW(eye.find(Image(320, 240)), std::invalid_argument);
  EXPECT_THROW(eye.find(Image(kWidth_px, kHeight_px, 3)), std::invalid_argument);
  CameraMount up = kMount;
  up.tilt_rad = -60 * kDegree;
  EXPECT_THROW(StripeProbe({}, kProbeLens, up, kWidth_px, kHeight_px, kLightHeight_m), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
