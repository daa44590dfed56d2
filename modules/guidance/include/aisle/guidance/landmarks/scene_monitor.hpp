#pragma once

#include <span>

#include "aisle/guidance/landmarks/scene_jump.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Notices that the vehicle was lifted and put elsewhere: from one image to the next everything is another.
/// That everything is gone proves nothing: light may have failed, or something stand before the camera.
class SceneMonitor {
 public:
  /// The vehicle has moved since the last call, by its odometry.
  void move(const Pose2& T_before_now);

  /// Takes in an image. Lines come and go: one that shows what is known to be here is no other scene.
  /// @return whether it shows, like the one before it, other things than were seen until then. False as long
  /// as there is too little to compare
  bool look(std::span<const LandmarkSighting> image, bool is_known_here = false);

 private:
  SceneJump<LandmarkSighting> jump_;
};

}  // namespace aisle
