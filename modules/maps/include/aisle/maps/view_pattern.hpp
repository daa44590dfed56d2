#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Places that a vehicle passes one after another, straight on, in the frame of a taught place.
struct ViewLane {
  double turned_rad = 0;        ///< of the whole lane about the taught place
  double lateral_m = 0;         ///< to the left
  std::vector<double> along_m;  ///< of the places, ascending

  Pose2 at(double path_m) const { return Pose2{0, 0, turned_rad} * Pose2{path_m, lateral_m, 0}; }
};

/// The places about a taught place from which views of it are learned (L96 Algorithm 3): nine along the path
/// and twelve on both sides of three of those, and the same turned to the left and to the right, 63 in all.
/// Distances and angles, which only the paper's lost figure tells, are ours.
std::vector<ViewLane> view_pattern();

}  // namespace aisle
