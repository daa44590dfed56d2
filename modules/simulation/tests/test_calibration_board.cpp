#include "aisle/simulation/calibration_board.hpp"

#include <gtest/gtest.h>

#include "aisle/core/angle.hpp"

using namespace aisle;

namespace {

TEST(CalibrationBoard, UprightItsColumnsRunToTheRightOfWhoLooksAtIt) {
  CalibrationBoard board;
  board.p_world_centre = {5, 1, 1.2};
  board.yaw_rad = kPi;  // seen from the origin, which looks along x: its right is -y
  const Vec3 upper_left = board.p_world_corner(0, 0), upper_right = board.p_world_corner(8, 0);
  EXPECT_NEAR(upper_left.y(), 1 + 0.12, 1e-12);
  EXPECT_NEAR(upper_right.y(), 1 - 0.12, 1e-12);
  EXPECT_NEAR(upper_left.z(), 1.2 + 0.075, 1e-12);
  EXPECT_NEAR(upper_left.x(), 5, 1e-12);
}

TEST(CalibrationBoard, LyingOnTheFloorItsUpperEdgePointsAwayFromWhoeverItFaced) {
  CalibrationBoard board;
  board.p_world_centre = {3, 0, 0};
  board.yaw_rad = kPi;
  board.pitch_rad = kPi / 2;
  const Vec3 upper_left = board.p_world_corner(0, 0);
  EXPECT_NEAR(upper_left.x(), 3 + 0.075, 1e-12);
  EXPECT_NEAR(upper_left.y(), 0.12, 1e-12);
  EXPECT_NEAR(upper_left.z(), 0, 1e-12);
  EXPECT_NEAR((board.R_world_print() * Vec3::UnitZ()).z(), -1, 1e-12);
}

TEST(CalibrationBoard, RolledItsUpperEdgeLeansToTheLeftOfWhoLooksAtIt) {
  CalibrationBoard board;
  board.yaw_rad = kPi;
  board.roll_rad = 0.1;
  const Vec3 up = board.R_world_print() * -Vec3::UnitY();
  EXPECT_GT(up.y(), 0.09);  // left of a viewer who looks along x
}

}  // namespace
