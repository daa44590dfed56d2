#include "aisle/simulation/calibration_board.hpp"

#include <Eigen/Geometry>

namespace aisle {

Mat3 CalibrationBoard::R_world_print() const {
  using Eigen::AngleAxisd;
  Mat3 facing_x;
  facing_x << 0, 0, -1,  //
      1, 0, 0,           //
      0, -1, 0;
  return AngleAxisd(yaw_rad, Vec3::UnitZ()) * AngleAxisd(-pitch_rad, Vec3::UnitY()) *
         AngleAxisd(roll_rad, Vec3::UnitX()).toRotationMatrix() * facing_x;
}

Vec3 CalibrationBoard::p_world_corner(int column, int row) const {
  const Vec3 p_print{(column - (columns - 1) / 2.0) * square_m, (row - (rows - 1) / 2.0) * square_m, 0};
  return p_world_centre + R_world_print() * p_print;
}

}  // namespace aisle
