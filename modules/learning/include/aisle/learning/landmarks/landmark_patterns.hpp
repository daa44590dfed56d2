#pragma once

#include <span>
#include <vector>

#include "aisle/maps/landmark_map.hpp"
#include "aisle/matching/mwght.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// C98 eq. (16): the weight of a landmark at this position when it is seen for the first time.
double confidence_weight(const Vec2& p_vehicle, double confidence_m2);

/// The learned and the seen pattern, both as a vehicle at some pose sees them or would see them: the
/// displacement between them is the correction of that pose.
struct LandmarkPatterns {
  std::vector<int> near;  ///< indices of the landmarks that may matter, in ascending order
  std::vector<WeightedPoint> learned, seen;

  /// @param confidence_m2  Cd of C98 eq. (16)
  /// @param window         displacements to be tried
  /// @param reach_m        reach of a vote
  void gather(const LandmarkMap& map, std::span<const LandmarkSighting> sightings, const Pose2& T_map_vehicle,
              double confidence_m2, const MwghtWindow& window, double reach_m);
};

}  // namespace aisle
