#pragma once

#include <span>

#include "aisle/guidance/landmarks/scene_jump.hpp"

namespace aisle {

/// Detects kidnapping by the laser markers' light: from one image to the next, the walls stand elsewhere.
/// Where only a line or two is in view, nothing else shows it.
class StripeMonitor {
 public:
  /// The vehicle has moved since the last call, by its odometry.
  void move(const Pose2& T_before_now);

  /// Takes in the laser returns in an image [vehicle frame]. An image that shows what is known to be here is
  /// no other place.
  /// @return whether this image, like the one before it, shows hardly any light where it was until then;
  /// false while there is too little to compare
  bool look(std::span<const Vec2> p_vehicle_returns, bool is_known_here = false);

 private:
  SceneJump<Vec2> jump_;
};

}  // namespace aisle
