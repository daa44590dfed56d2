#include <gmock/gmock.h>

#include <algorithm>

#include "aisle/vision/standing_things.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using Seen = StandingThingDetector::Seen;

constexpr CameraIntrinsics kLens{460, 460, 319.5, 239.5};
const CameraMount kMount{{0.85, 0, 1}, 0.25, 0, 0};

/// An endless floor, and what a function puts in the way of the ray through each pixel: a grey level, or less
/// than 0 where the floor is seen.
template <class InTheWay>
Image picture(const InTheWay& in_the_way, int floor = 140) {
  Image image(640, 480);
  const CameraModel camera(kLens);
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) {
      const Vec3 ray = kMount.R_vehicle_camera() * camera.ray(Vec2(u, v))->direction;
      const int level = in_the_way(ray);
      image.row(v)[u] = static_cast<std::uint8_t>(level >= 0 ? level : ray.z() < 0 ? floor : 210);
    }
  }
  return image;
}

/// A board across the way, upright on the floor.
struct Board {
  double x_m, left_m, right_m, height_m;

  bool hides(const Vec3& ray) const {
    const double length = (x_m - kMount.p_vehicle_camera.x()) / ray.x();
    const double y_m = length * ray.y(), z_m = kMount.p_vehicle_camera.z() + length * ray.z();
    return y_m < left_m && y_m > right_m && z_m >= 0 && z_m < height_m;
  }
};

/// A rectangle on the floor.
struct Sheet {
  double near_m, far_m, left_m, right_m;

  bool shows(const Vec3& ray) const {
    if (ray.z() >= 0) return false;
    const Vec3 p = kMount.p_vehicle_camera - kMount.p_vehicle_camera.z() / ray.z() * ray;
    return p.x() > near_m && p.x() < far_m && p.y() < left_m && p.y() > right_m;
  }
};

StandingThingDetector detector() {
  return {{}, kLens, kMount, 640, 480};
}

/// What is seen after the empty floor.
std::vector<StandingThing> things_in(const Image& image) {
  StandingThingDetector eye = detector();
  eye.detect(picture([](const Vec3&) { return -1; }));
  return eye.detect(image);
}

TEST(StandingThings, NoneStandOnABareFloor) {
  StandingThingDetector eye = detector();
  EXPECT_THAT(eye.detect(picture([](const Vec3&) { return -1; })), IsEmpty());
  EXPECT_EQ(eye.seen_at({4, 0}), Seen::kFree);
  EXPECT_EQ(eye.seen_at({1.2, 0}), Seen::kTooNear);
  EXPECT_EQ(eye.seen_at({-1, 0}), Seen::kNothing);
  EXPECT_EQ(eye.seen_at({4, 9}), Seen::kNothing);
}

TEST(StandingThings, ABoxIsSeenWhereItMeetsTheFloor) {
  for (const double x_m : {2.5, 3.0, 3.5}) {
    const Board box{x_m, 0.3, -0.2, 0.5};
    const auto things = things_in(picture([&](const Vec3& ray) { return box.hides(ray) ? 60 : -1; }));
    ASSERT_GE(things.size(), 5U);
    for (std::size_t i = 2; i + 2 < things.size(); ++i) {  // its edges cover their rays in part
      EXPECT_NEAR(things[i].p_vehicle.x(), x_m, 0.05 * x_m);
      EXPECT_GT(things[i].p_vehicle.y(), -0.25);
      EXPECT_LT(things[i].p_vehicle.y(), 0.35);
      EXPECT_FALSE(things[i].foot_hidden);
    }
  }
}

TEST(StandingThings, NothingIsKnownBehindABox) {
  const Board box{3, 0.3, -0.3, 0.5};
  StandingThingDetector eye = detector();
  eye.detect(picture([&](const Vec3& ray) { return box.hides(ray) ? 60 : -1; }));
  EXPECT_EQ(eye.seen_at({2.5, 0}), Seen::kFree);
  EXPECT_EQ(eye.seen_at({3.5, 0}), Seen::kNothing);
  EXPECT_EQ(eye.seen_at({3.5, 1}), Seen::kFree);
}

TEST(StandingThings, PapersAndJointsLieOnTheFloor) {
  for (const double near_m : {2.0, 2.6, 4.0, 5.5}) {
    const Sheet paper{near_m, near_m + 0.3, 0.15, -0.1}, joint{near_m - 0.1, near_m - 0.095, 9, -9};
    EXPECT_THAT(things_in(picture([&](const Vec3& ray) {
                  return paper.shows(ray) ? 245 : joint.shows(ray) ? 100 : -1;
                })),
                IsEmpty())
        << near_m;
  }
}

TEST(StandingThings, AWallThatLooksLikeTheFloorIsSeenByItsSkirting) {
  const Board wall{4, 9, -9, 3}, skirting{4, 9, -9, 0.1};
  const auto things = things_in(picture([&](const Vec3& ray) {
    return skirting.hides(ray) ? 30 : wall.hides(ray) ? 145 : -1;
  }));
  ASSERT_GE(things.size(), 20U);
  for (const StandingThing& thing : things) EXPECT_NEAR(thing.p_vehicle.x(), 4, 0.2);
}

TEST(StandingThings, LightThatFadesOverTheFloorIsNoThing) {
  EXPECT_THAT(things_in(picture([&](const Vec3& ray) {
                if (ray.z() >= 0) return -1;
                const double away_m = -kMount.p_vehicle_camera.z() / ray.z() * ray.x();
                return static_cast<int>(140 + 60 * std::clamp((away_m - 1.5) / 2.5, 0.0, 1.0));
              })),
              IsEmpty());
}

TEST(StandingThings, WhatBeginsBelowThePictureHasItsFootHidden) {
  const Board near{1.2, 0.2, -0.2, 1.5};
  const auto things = things_in(picture([&](const Vec3& ray) { return near.hides(ray) ? 40 : -1; }));
  ASSERT_GE(things.size(), 20U);
  EXPECT_TRUE(std::all_of(things.begin(), things.end(), [](const auto& thing) { return thing.foot_hidden; }));
}

TEST(StandingThings, ColourSetsAThingOffTheFloorThatIsAsBright) {
  const Board cone{3, 0.15, -0.15, 0.5};
  const Image grey = picture([&](const Vec3& ray) { return cone.hides(ray) ? 1 : -1; });
  Image colour(640, 480, 3);
  for (std::size_t i = 0; i < grey.bytes.size(); ++i) {
    const bool is_cone = grey.bytes[i] == 1;
    colour.bytes[3 * i] = is_cone ? 220 : grey.bytes[i];
    colour.bytes[3 * i + 1] = is_cone ? 120 : grey.bytes[i];
    colour.bytes[3 * i + 2] = is_cone ? 80 : grey.bytes[i];
  }
  const auto things = detector().detect(colour);
  ASSERT_GE(things.size(), 5U);
  EXPECT_NEAR(things[0].p_vehicle.x(), 3, 0.15);
}

TEST(StandingThings, LampsThatGoOutAreNoThing) {
  StandingThingDetector eye = detector();
  eye.detect(picture([](const Vec3&) { return -1; }));
  EXPECT_THAT(eye.detect(picture([](const Vec3& ray) { return ray.z() < 0 ? 50 : 75; })), IsEmpty());
}

TEST(StandingThings, OtherPicturesAreRefused) {
  StandingThingDetector eye = detector();
  EXPECT_THROW(eye.detect(Image(320, 240)), std::invalid_argument);
  EXPECT_THROW(eye.detect({}), std::invalid_argument);
  EXPECT_THROW(StandingThingDetector({}, kLens, {{0, 0, 1}, -1.2, 0, 0}, 640, 480), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
