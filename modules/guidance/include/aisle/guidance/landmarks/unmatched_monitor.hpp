#pragma once

#include <span>
#include <utility>

#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/landmarks/taught_view.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// On how much path the vehicle has seen things of which none is known. Unknown things contradict nothing
/// where the map has a gap, and standing the vehicle sees the same ones again and again. A long path of them
/// does, and a chance match among them does not make them good.
class UnmatchedMonitor {
 public:
  /// @param taught  of what stands elsewhere nothing can be known
  /// @param sightings_min  fewer unknown things make no image unmatched
  UnmatchedMonitor(TaughtView taught, int sightings_min)
      : taught_(std::move(taught)), sightings_min_(sightings_min) {}

  /// Nothing that was seen so far counts.
  void start();

  /// Takes in an image.
  /// @param fits  it shows what is known where the vehicle believes to be
  /// @param path_m  since the image before
  void look(std::span<const LandmarkSighting> image, bool fits, const Pose2& T_map_believed, double path_m);

  /// Of the last image.
  bool is_unmatched() const { return is_unmatched_; }
  /// Unmatched images add to it, one that fits halves it.
  double path_m() const { return travelled_m_; }

 private:
  TaughtView taught_;
  int sightings_min_;
  bool is_unmatched_ = false;
  double travelled_m_ = 0;
};

}  // namespace aisle
