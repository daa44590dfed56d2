#pragma once

#include <span>

#include "aisle/learning/landmarks/landmark_localiser.hpp"

namespace aisle {

/// State of the suspicion that the vehicle is not where it believes to be.
enum class Suspicion {
  kOpen,
  kDispelled,  ///< what it sees does not contradict the map there
  kConfirmed,  ///< it contradicts the map
};

/// Consistency check for a standing vehicle that may have been kidnapped: are the building's landmarks seen
/// from where it believes to be? A single image may miss them, or show little but wrong floor points. At
/// another place, image after image contradicts the map, or fits it only with an offset, as many lines do
/// somewhere: then hardly any expected landmark is seen, and few of the sightings are known.
class PlaceConsistency {
 public:
  PlaceConsistency(const LandmarkLocaliserParams& matching, const VehicleDescription& vehicle)
      : landmark_sigma_m_(matching.landmark_sigma_m), localiser_(matching, vehicle, {}) {}

  /// Forgets what was seen so far.
  /// @param has_jumped  walls stand elsewhere than a moment ago: unless images fit, the vehicle is elsewhere
  void start(bool has_jumped = false) {
    images_ = fitting_ = contradicting_ = mostly_known_ = expected_ = seen_ = 0;
    has_jumped_ = has_jumped;
  }

  /// Takes in one more image.
  /// @param T_map_believed  where the vehicle believes to be now
  Suspicion look(const LandmarkMap& map, const UncertainPose2& T_map_believed,
                 std::span<const LandmarkSighting> image);

 private:
  double landmark_sigma_m_;
  LandmarkLocaliser localiser_;
  bool has_jumped_ = false;
  int images_ = 0, fitting_ = 0, contradicting_ = 0;
  int mostly_known_ = 0;         ///< images with hardly anything but known lines
  int expected_ = 0, seen_ = 0;  ///< landmarks, summed over all images
};

}  // namespace aisle
