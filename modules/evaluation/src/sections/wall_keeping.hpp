#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "aisle/evaluation/error_figure.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// How exactly a vehicle keeps its learned distances from the walls to its right, by the ground truth.
class WallKeeping {
 public:
  explicit WallKeeping(const World& world);

  /// A cycle in which a wall-floor edge is followed.
  /// @param piece      of the path, along which one distance is kept
  /// @param T_world    true position of the vehicle, with the heading of the path
  /// @param learned_m  learned distance from the wall
  void add(std::size_t piece, const Pose2& T_world, double learned_m);

  /// For each piece only the wall to the right of most of it counts. What recedes from that wall, such as an
  /// alcove or the next corridor, is left out, and so is whatever is off by more than 0.25 m.
  ErrorFigure error_m() const;

 private:
  struct Beside {
    double wall_line_m = 0;  ///< from the world's origin to the line that the wall lies on
    double off_m = 0;        ///< true minus learned distance
  };

  std::vector<Segment2> base_lines_;
  double skirting_m_;
  std::map<std::size_t, std::vector<Beside>> of_piece_;
};

}  // namespace aisle
