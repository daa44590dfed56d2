#pragma once

#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// A wall's evidence is bounded, so that a building forgets: nothing makes a wall surer than this, and after
/// so many trips that saw through it, it is gone.
inline constexpr int kSureEvidence = 3;
/// With less, it is uncertain: one trip has seen it, and no other has seen it again.
inline constexpr int kCertainEvidence = 2;

/// One straight wall face. The free side, from which it was seen, lies on the LEFT of start -> end.
struct Wall {
  Segment2 segment;            ///< in `map` [m]
  bool is_orthogonal = false;  ///< lies exactly on the map's axes; else oblique, with a direction of its own
  WallEnd start = WallEnd::kUnknown;
  WallEnd end = WallEnd::kUnknown;
  int sightings = 0;             ///< on how many half-metre legs of the path it was seen
  double sigma_m = 0;            ///< standard deviation of its position, perpendicular to it
  int evidence = kSureEvidence;  ///< 1 .. kSureEvidence: trips that saw it, less those that saw through it

  bool is_certain() const { return evidence >= kCertainEvidence; }
};

/// The walls of a building as a compact map. The dominant orthogonal directions, if there are any, are the
/// axes of `map`.
struct WallMap {
  std::vector<Wall> walls;

  /// Share of the total wall length that lies on the axes, 0 .. 1; 0 where there is no length.
  double orthogonal_share() const;
  /// Total length of all walls [m].
  double length_m() const;
};

}  // namespace aisle
