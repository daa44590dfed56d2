#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/maps/landmark_map.hpp"

namespace aisle {

/// A landmark of a run, and when it was seen. A place passed twice has its landmarks twice until the loop is
/// closed.
struct RunLandmark {
  Landmark landmark;
  std::size_t first_cycle = 0;
  std::size_t last_cycle = 0;
};

/// The landmarks seen around the time of a cycle, for one cycle after another.
class PresentLandmarks {
 public:
  explicit PresentLandmarks(std::span<const RunLandmark> all);

  /// Moves on to a cycle, not before the last one.
  const LandmarkMap& at(std::size_t cycle);
  /// The index among all landmarks of one in the map.
  std::size_t original(std::size_t index_in_map) const { return by_first_cycle_[index_in_map]; }

 private:
  std::span<const RunLandmark> all_;
  std::vector<std::size_t> by_first_cycle_;  ///< indices of all landmarks
  LandmarkMap map_;                          ///< those seen so far, in this order
  std::vector<std::size_t> present_;         ///< indices in the map of those still present
};

}  // namespace aisle
