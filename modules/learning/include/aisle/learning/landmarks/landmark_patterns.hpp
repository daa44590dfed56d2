#pragma once

#include <span>
#include <vector>

#include "aisle/maps/landmark_map.hpp"
#include "aisle/matching/mwght.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// C98 eq. (16): how much a landmark at this place counts when it is seen for the first time.
double confidence_weight(const Vec2& p_vehicle, double confidence_m2);

/// What is matched with what, both as a vehicle at some place sees or would see it: the displacement between
/// them is then the correction of its pose.
struct LandmarkPatterns {
  std::vector<int> near;  ///< landmarks that may come into play, in ascending order
  std::vector<WeightedPoint> learned, seen;

  /// @param confidence_m2  Cd of C98 eq. (16)
  /// @param window         displacements that will be tried
  /// @param reach_m        how far votes reach
  void gather(const LandmarkMap& map, std::span<const LandmarkSighting> sightings, const Pose2& T_map_vehicle,
              double confidence_m2, const MwghtWindow& window, double reach_m);
};

}  // namespace aisle
