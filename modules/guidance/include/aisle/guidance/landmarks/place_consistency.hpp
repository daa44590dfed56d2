#pragma once

#include <span>

#include "aisle/learning/landmarks/landmark_localiser.hpp"

namespace aisle {

/// What has become of the suspicion that the vehicle is not where it believes to be.
enum class Suspicion {
  kOpen,
  kDispelled,  ///< what it sees does not contradict the map there
  kConfirmed,  ///< it does
};

/// For a vehicle that stands and suspects to have been lifted: whether the building's landmarks are seen from
/// where it believes to be. A single image may miss them, or show little but wrong feet; elsewhere, image
/// after image contradicts the map, or fits it only at some displacement, as many lines do somewhere: of
/// what should be seen hardly anything is where it should be, and little of what is seen is known.
class PlaceConsistency {
 public:
  PlaceConsistency(const LandmarkLocaliserParams& matching, const VehicleDescription& vehicle)
      : landmark_sigma_m_(matching.landmark_sigma_m), localiser_(matching, vehicle, {}) {}

  /// Nothing that was seen so far counts.
  /// @param has_jumped  walls stand elsewhere than a moment ago: images must fit, or it is elsewhere
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
  int mostly_known_ = 0;         ///< images that show hardly anything but known lines
  int expected_ = 0, seen_ = 0;  ///< landmarks, in all images together
};

}  // namespace aisle
