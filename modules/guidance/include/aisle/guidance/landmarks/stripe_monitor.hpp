#pragma once

#include <span>

#include "aisle/guidance/landmarks/scene_jump.hpp"

namespace aisle {

/// Notices by the laser markers' light that the vehicle was lifted and put elsewhere: from one image to the
/// next the walls stand elsewhere. Where no more than a line or two is in view nothing else tells it.
class StripeMonitor {
 public:
  /// The vehicle has moved since the last call, by its odometry.
  void move(const Pose2& T_before_now);

  /// Takes in what an image shows of the light [vehicle frame]. One that shows what is known to be here is
  /// no other place.
  /// @return whether this image, like the one before it, shows hardly any light where it was until then.
  /// False as long as there is too little to compare
  bool look(std::span<const Vec2> p_vehicle_lit, bool is_known_here = false);

 private:
  SceneJump<Vec2> jump_;
};

}  // namespace aisle
