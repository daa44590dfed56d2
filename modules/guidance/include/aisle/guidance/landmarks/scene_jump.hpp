#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/guidance/landmarks/motion_since.hpp"

namespace aisle {

/// Detects a jump between scenes: an image that shows hardly anything of the scene before, followed by one
/// that shows the same new scene. A single image may be an effect of the light.
/// @tparam SceneFeature  a feature that images show, in the vehicle frame
template <class SceneFeature>
class SceneJump {
 public:
  struct Limits {
    std::size_t compared_min = 0;  ///< features needed in either image
    double other_share_max = 0;    ///< at most this share of features in common: another scene
    double same_share_min = 0;     ///< at least this share of features in common: the same scene
  };

  /// The vehicle has moved since the last call, by its odometry.
  /// @param carry  carry(features, T_now_before) transforms features into the present vehicle frame
  template <class Carry>
  void move(const Pose2& T_before_now, Carry carry) {
    carry(known_, T_before_now.inverse());
    carry(other_, T_before_now.inverse());
    since_known_.move(T_before_now);
  }

  /// Takes in an image.
  /// @param is_known_here  it shows what is known to be here, so it is no other scene
  /// @param known_share    known_share(image, other): share of an image's features that are in another one
  /// @return whether it is the second image of another scene; false while there is too little to compare
  template <class KnownShare>
  bool look(std::span<const SceneFeature> image, bool is_known_here, const Limits& limits,
            KnownShare known_share) {
    if (image.size() < limits.compared_min) return false;
    const bool can_tell = known_.size() >= limits.compared_min && since_known_.is_comparable();
    const bool goes_on = is_known_here || !can_tell || known_share(image, known_) > limits.other_share_max;
    const bool is_elsewhere = !goes_on && other_.size() >= limits.compared_min &&
                              known_share(image, other_) >= limits.same_share_min;
    if (!goes_on && !is_elsewhere) {
      other_.assign(image.begin(), image.end());
      return false;
    }
    known_.assign(image.begin(), image.end());
    since_known_.start();
    other_.clear();
    return is_elsewhere;
  }

 private:
  std::vector<SceneFeature> known_;  ///< of the last image that continued the scene, as seen now
  MotionSince since_known_;
  std::vector<SceneFeature> other_;  ///< of the last image if it did not continue the scene
};

}  // namespace aisle
