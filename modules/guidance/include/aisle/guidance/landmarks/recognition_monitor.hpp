#pragma once

#include <bitset>
#include <cstddef>

#include "aisle/guidance/landmarks/motion_since.hpp"

namespace aisle {

/// Detects kidnapping to a place where the map contains little: nearly everything in view was known, and from
/// one image to the next hardly anything is. Where the map merely ends, known lines disappear one by one.
class RecognitionMonitor {
 public:
  /// Forgets what was seen so far.
  void start() { *this = {}; }

  /// The vehicle has moved since the last call, by its odometry.
  void move(const Pose2& T_before_now) { since_known_.move(T_before_now); }

  /// Takes in an image.
  /// @param pairs  number of its sightings that lie on known landmarks
  /// @param is_known_here  it shows what is known to be here
  /// @return whether the images since the last that was known show that the vehicle is elsewhere
  bool look(std::size_t sightings, std::size_t pairs, bool is_known_here) {
    if (is_known_here) {
      was_steady_ = known_.count() >= kKnownLeast;
      since_known_.start();
      unknown_ = {};
    } else {
      ++unknown_.images;
      unknown_.sightings += sightings;
      unknown_.pairs += pairs;
    }
    known_ = known_ << 1 | Images(is_known_here ? 1 : 0);
    return was_steady_ && since_known_.is_comparable() && unknown_.images >= kUnknownImages &&
           unknown_.sightings >= kUnknownSightings && kPairedOneIn * unknown_.pairs <= unknown_.sightings;
  }

 private:
  using Images = std::bitset<10>;
  static constexpr std::size_t kKnownLeast = 6;  ///< of the ten images before the last that was known
  static constexpr std::size_t kUnknownImages = 5;
  static constexpr std::size_t kUnknownSightings = 20;
  static constexpr std::size_t kPairedOneIn = 5;  ///< sightings in them, at most: as many as by chance

  struct Tally {
    std::size_t images = 0, sightings = 0, pairs = 0;
  };

  Images known_;             ///< which of the last images were known
  bool was_steady_ = false;  ///< most images before the last known one were known, too
  Tally unknown_;            ///< since the last known image
  MotionSince since_known_;
};

}  // namespace aisle
