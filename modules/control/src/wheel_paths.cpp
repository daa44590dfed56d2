#include "wheel_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aisle {
namespace {

/// What the front reference point drives while base_link drives a piece; its heading is that of the wheels.
PathPiece front_piece(const FrontSteered& vehicle, const PathPiece& rear) {
  const double across_m = vehicle.wheelbase_m * rear.arc.turn_rad;
  const double steering_rad = std::atan(across_m / rear.arc.length_m);
  const double length_m = std::hypot(rear.arc.length_m, across_m);
  return {front_pose(vehicle, rear.T_map_start) * Pose2{0, 0, steering_rad},
          {std::copysign(length_m, rear.arc.length_m), rear.arc.turn_rad}};
}

double distance(const std::vector<PathPiece>& pieces, const Vec2& p_map) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const PathPiece& piece : pieces) {
    const Vec2 nearest = piece.at(piece.nearest(p_map, 0, piece.path_m())).position();
    least_m = std::min(least_m, (nearest - p_map).norm());
  }
  return least_m;
}

}  // namespace

WheelPaths::WheelPaths(const FrontSteered& vehicle, const Path& path, const PathPoint& from, double reach_m)
    : vehicle_(vehicle), gear_(gear_of(path.pieces()[from.piece].arc.length_m)) {
  const auto& pieces = path.pieces();
  const std::size_t end = path.leg_end(from.piece);
  std::size_t first = from.piece;
  while (first > 0 && path.leg_end(first - 1) == end && from.along_m - path.start_m(first) < reach_m) --first;
  std::size_t last = from.piece;
  while (last + 1 < end && path.start_m(last + 1) - from.along_m < reach_m) ++last;

  const bool begins = from.along_m - path.start_m(first) < reach_m;
  if (begins) {
    add({pieces[first].T_map_start * Pose2{-sign(gear_) * reach_m, 0, 0}, {sign(gear_) * reach_m, 0}});
  }
  for (std::size_t i = first; i <= last; ++i) add(pieces[i]);
  const bool ends = path.start_m(last) + pieces[last].path_m() - from.along_m < reach_m;
  if (ends) add({pieces[last].end(), {sign(gear_) * reach_m, 0}});
}

void WheelPaths::add(const PathPiece& rear) {
  rear_.push_back(rear);
  front_.push_back(front_piece(vehicle_, rear));
}

double WheelPaths::distance_sum(const Pose2& T_map_vehicle) const {
  return distance(front_, front_pose(vehicle_, T_map_vehicle).position()) +
         distance(rear_, T_map_vehicle.position());
}

}  // namespace aisle
