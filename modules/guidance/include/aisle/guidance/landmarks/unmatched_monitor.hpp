#pragma once

#include <span>
#include <utility>

#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/landmarks/taught_view.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Measures along how much path the vehicle has seen lines of which none is known. A few unknown lines
/// contradict nothing, as the map may have a gap, and a standing vehicle sees the same ones again and again.
/// A long path of them does contradict it, and a single chance match does not cancel them.
class UnmatchedMonitor {
 public:
  /// @param taught         only lines inside this view can be known
  /// @param sightings_min  an image with fewer unknown lines is not unmatched
  UnmatchedMonitor(TaughtView taught, int sightings_min)
      : taught_(std::move(taught)), sightings_min_(sightings_min) {}

  /// Forgets what was seen so far.
  void start();

  /// Takes in an image.
  /// @param fits  it shows what is known where the vehicle believes to be
  /// @param path_m  distance since the previous image
  void look(std::span<const LandmarkSighting> image, bool fits, const Pose2& T_map_believed, double path_m);

  /// Whether the last image is unmatched.
  bool is_unmatched() const { return is_unmatched_; }
  /// Path with unmatched images; an image that fits halves it.
  double path_m() const { return travelled_m_; }

 private:
  TaughtView taught_;
  int sightings_min_;
  bool is_unmatched_ = false;
  double travelled_m_ = 0;
};

}  // namespace aisle
