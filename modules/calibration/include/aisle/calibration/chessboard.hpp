#pragma once

#include <optional>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A printed chessboard. Its frame: origin at the first inner corner, x along the row of corners, y to the
/// next row, z into the board. The outer square before the first corner is black.
struct Chessboard {
  int columns = 9;  ///< inner corners in a row; >= 3
  int rows = 6;     ///< inner corners in a column; >= 3
  double square_m = 0.025;

  /// Whether its colours distinguish it from the same board turned by 180 or 90 degrees.
  bool has_one_orientation() const { return (columns + rows) % 2 == 1; }

  /// All inner corners, row by row.
  std::vector<Vec3> p_board_corners() const;
};

/// Where a chessboard lies on the floor, in base_link: the middle of its corners, and the heading of its
/// upper edge's direction, from the last row to the first. Heading 0: seen from behind the board, looking
/// ahead, it is as printed, with the black outer square at the upper left.
struct BoardOnFloor {
  Vec2 p_vehicle_centre = Vec2::Zero();
  double heading_rad = 0;

  /// The board's corners on the floor, in the order of Chessboard::p_board_corners.
  std::vector<Vec2> p_vehicle_corners(const Chessboard& board) const;
};

/// The inner corners in an image, to a fraction of a pixel, in the order of Chessboard::p_board_corners: the
/// square before the first one is black. A board without a unique orientation may be found turned by
/// 180 degrees.
/// @return nullopt unless the whole board is in view
std::optional<std::vector<Vec2>> find_chessboard(const Image& image, const Chessboard& board);

}  // namespace aisle
