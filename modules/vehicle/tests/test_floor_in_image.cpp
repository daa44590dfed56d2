#include "aisle/vehicle/floor_in_image.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// 1 m high and 0.5 m before base_link, tilted down by 20 degrees; 40 degrees of view downwards and upwards.
CameraDescription camera() {
  CameraDescription camera{.width_px = 641, .height_px = 481};
  camera.intrinsics = {.fx_px = 240 / std::tan(40 * kDegree),
                       .fy_px = 240 / std::tan(40 * kDegree),
                       .cx_px = 320,
                       .cy_px = 240};
  camera.mount = {.p_vehicle_camera = {0.5, 0, 1}, .tilt_rad = 20 * kDegree};
  return camera;
}

TEST(FloorInImage, BeginsWhereTheLowestRaysMeetTheFloor) {
  const FloorInImage floor(camera());
  const double nearest_m = 0.5 + 1 / std::tan(60 * kDegree);
  EXPECT_NEAR(floor.nearest_m(), nearest_m, 1e-6);
  EXPECT_TRUE(floor.shows({nearest_m + 0.01, 0}));
  EXPECT_FALSE(floor.shows({nearest_m - 0.01, 0}));
  EXPECT_TRUE(floor.shows({20, 0}));
}

TEST(FloorInImage, EndsAtItsSides) {
  const FloorInImage floor(camera());
  EXPECT_TRUE(floor.shows({3, 2}));
  EXPECT_TRUE(floor.shows({3, -2}));
  EXPECT_FALSE(floor.shows({3, 4}));
  EXPECT_FALSE(floor.shows({-3, 0})) << "behind the vehicle";
}

TEST(FloorInImage, ACameraThatLooksUpwardsShowsNone) {
  CameraDescription upwards = camera();
  upwards.mount.tilt_rad = -60 * kDegree;
  const FloorInImage floor(upwards);
  EXPECT_EQ(floor.nearest_m(), 0);
  EXPECT_FALSE(floor.shows({3, 0}));
}

}  // namespace
}  // namespace aisle
