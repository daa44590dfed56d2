#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Places that a vehicle passes in a straight line, in the frame of a taught place.
struct ViewLane {
  double turned_rad = 0;        ///< rotation of the whole lane about the taught place
  double lateral_m = 0;         ///< to the left
  std::vector<double> along_m;  ///< of the places, ascending

  Pose2 at(double path_m) const { return Pose2{0, 0, turned_rad} * Pose2{path_m, lateral_m, 0}; }
};

/// The places around a taught place from which views of it are learned (L96 Algorithm 3): nine along the path
/// and twelve to both sides of three of those, and the same turned to the left and to the right, 63 in all.
/// The paper's figure with the distances and angles is lost; the values are ours.
std::vector<ViewLane> view_pattern();

}  // namespace aisle
