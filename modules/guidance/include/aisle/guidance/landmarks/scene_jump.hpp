#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/guidance/landmarks/motion_since.hpp"

namespace aisle {

/// Tells images that go on from one another from a jump: an image that shows hardly anything of the scene
/// until then, and one after it that shows the same again. One alone may be a whim of the light.
/// @tparam Thing  what an image shows, as it is seen from the vehicle
template <class Thing>
class SceneJump {
 public:
  struct Limits {
    std::size_t compared_min = 0;  ///< things, in either image
    double other_share_max = 0;    ///< of an image's things, known from the scene before: another scene
    double same_share_min = 0;     ///< the same: the same scene
  };

  /// The vehicle has moved since the last call, by its odometry.
  /// @param carry  carry(things, T_now_before): as they are seen now
  template <class Carry>
  void move(const Pose2& T_before_now, Carry carry) {
    carry(known_, T_before_now.inverse());
    carry(other_, T_before_now.inverse());
    since_known_.move(T_before_now);
  }

  /// Takes in an image.
  /// @param is_known_here  it shows what is known to be here, and so no other scene
  /// @param known_share  known_share(image, other): how much of an image another one shows too
  /// @return whether it is the second of another scene. False as long as there is too little to compare
  template <class KnownShare>
  bool look(std::span<const Thing> image, bool is_known_here, const Limits& limits, KnownShare known_share) {
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
  std::vector<Thing> known_;  ///< of the last image that went on from the one before, as seen now
  MotionSince since_known_;
  std::vector<Thing> other_;  ///< of the last image if it did not
};

}  // namespace aisle
