#pragma once

#include "aisle/geometry/pose2.hpp"
#include "path_adjustment.hpp"

namespace aisle {

constexpr int kPieceUnknowns = 5;  ///< of a piece: x, y, theta of its start, length, turn

/// How the point at `share` (0 .. 1) of a piece changes with the unknowns of the piece.
inline Eigen::Matrix<double, 3, kPieceUnknowns> place_slopes(const LoosePiece& piece, double share) {
  const Arc part{share * piece.arc().length_m, share * piece.turn_rad};
  const Vec2 lever = rotate(piece.T_map_start.theta, end_pose(part).position());
  const Mat32 by_part = end_pose_jacobian(part);
  Eigen::Matrix<double, 3, kPieceUnknowns> slopes;
  slopes.leftCols<3>().setIdentity();
  slopes.col(2) << left_normal(lever), 1;
  slopes.rightCols<2>() = share * by_part;
  slopes.topRightCorner<2, 2>() = rotation(piece.T_map_start.theta) * slopes.topRightCorner<2, 2>().eval();
  slopes.col(3) *= piece.kind == LoosePiece::Kind::kTurnOnTheSpot ? 0 : sign(piece.gear);
  slopes.col(4) *= piece.kind == LoosePiece::Kind::kLine ? 0 : 1;
  return slopes;
}

}  // namespace aisle
