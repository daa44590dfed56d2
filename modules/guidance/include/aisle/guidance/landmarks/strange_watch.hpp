#pragma once

#include <span>
#include <utility>

#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/landmarks/taught_view.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// On how much way the vehicle has seen things of which none is known. Unknown things contradict nothing
/// where the map has a gap, and standing the vehicle sees the same ones again and again. A long way of them
/// does, and a chance match among them does not make them good.
class StrangeWatch {
 public:
  /// @param taught  of what stands elsewhere nothing can be known
  /// @param sightings_min  fewer unknown things make no picture strange
  StrangeWatch(TaughtView taught, int sightings_min)
      : taught_(std::move(taught)), sightings_min_(sightings_min) {}

  /// Nothing that was seen so far counts.
  void start();

  /// Takes in a picture.
  /// @param fits  it shows what is known where the vehicle believes to be
  /// @param way_m  since the picture before
  void look(std::span<const LandmarkSighting> picture, bool fits, const Pose2& T_map_believed, double way_m);

  /// Of the last picture.
  bool is_strange() const { return is_strange_; }
  /// Strange pictures add to it, one that fits halves it.
  double way_m() const { return way_m_; }

 private:
  TaughtView taught_;
  int sightings_min_;
  bool is_strange_ = false;
  double way_m_ = 0;
};

}  // namespace aisle
