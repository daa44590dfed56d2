#pragma once

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A chessboard to calibrate a camera with: on a wall, on the floor or held in the room. With all angles 0 it
/// is upright and its print faces along x of the world; a viewer of the print sees the columns of corners
/// from left to right and the rows from top to bottom. It is turned by roll, then pitch, then yaw, each about
/// an axis of the world through its centre.
struct CalibrationBoard {
  Vec3 p_world_centre{0, 0, 1};  ///< of the print
  double yaw_rad = 0;            ///< heading that the print faces
  double pitch_rad = 0;          ///< facing up positive; 90 degrees: it lies on the floor
  double roll_rad = 0;           ///< positive: its upper edge leans to the viewer's left
  int columns = 9;               ///< inner corners in a row
  int rows = 6;                  ///< inner corners in a column
  double square_m = 0.03;

  /// Width and height of the print with the white margin of one square around the squares [m].
  Vec2 size_m() const { return {(columns + 3) * square_m, (rows + 3) * square_m}; }

  /// Takes directions of the print (x right, y down, z into the board, as its viewer sees it) to
  /// directions of the world.
  Mat3 R_world_print() const;

  /// An inner corner, counted from the upper left one. The outer square at the upper left is black.
  Vec3 p_world_corner(int column, int row) const;
};

}  // namespace aisle
