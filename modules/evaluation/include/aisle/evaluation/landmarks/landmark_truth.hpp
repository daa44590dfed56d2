#pragma once

#include <span>

#include "aisle/evaluation/map_truth.hpp"
#include "aisle/maps/landmark_map.hpp"
#include "aisle/simulation/vertical_edges.hpp"

namespace aisle {

/// How well a learned map's landmarks agree with the simulated world.
struct LandmarkTruth {
  int landmarks = 0;
  int real = 0;           ///< at most 15 cm from a true vertical line
  double rms_m = 0;       ///< distance of the real ones from their true lines; 0 if there is none
  int sure = 0;           ///< of weight 1 or more: "real vertical lines" in C98 Fig. 11
  int sure_and_real = 0;  ///< of these
};

/// @param truth  how the map lies in the world, for each landmark by the nearest pose of the taught run; not
///               empty
LandmarkTruth compare_with_truth(const LandmarkMap& map, const MapTruth& truth,
                                 std::span<const VerticalEdge> edges);

}  // namespace aisle
