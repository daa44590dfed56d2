#pragma once

#include <span>

#include "aisle/guidance/landmarks/scene_jump.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Detects kidnapping: from one image to the next, all lines are different. That all lines are gone proves
/// nothing: the light may have failed, or something may stand before the camera.
class SceneMonitor {
 public:
  /// The vehicle has moved since the last call, by its odometry.
  void move(const Pose2& T_before_now);

  /// Takes in an image. As lines come and go, an image that shows what is known to be here is no other scene.
  /// @return whether it is the second in a row of another scene; false while there is too little to compare
  bool look(std::span<const LandmarkSighting> image, bool is_known_here = false);

 private:
  SceneJump<LandmarkSighting> jump_;
};

}  // namespace aisle
