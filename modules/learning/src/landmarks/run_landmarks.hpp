#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/maps/landmark_map.hpp"

namespace aisle {

/// A landmark of a run, and when it was seen. A place that the run came by twice has its landmarks twice
/// until the loop is closed.
struct RunLandmark {
  Landmark landmark;
  std::size_t first_cycle = 0;
  std::size_t last_cycle = 0;
};

/// The landmarks that were seen about the time of one cycle after another.
class PresentLandmarks {
 public:
  explicit PresentLandmarks(std::span<const RunLandmark> all);

  /// Moves on to a cycle, which is not before the last one.
  const LandmarkMap& at(std::size_t cycle);
  /// Which of all landmarks one of the map is.
  std::size_t original(std::size_t index_in_map) const { return by_first_cycle_[index_in_map]; }

 private:
  std::span<const RunLandmark> all_;
  std::vector<std::size_t> by_first_cycle_;  ///< indices of all landmarks
  LandmarkMap map_;                          ///< those that have come, in this order
  std::vector<std::size_t> present_;         ///< of the map, those that are not gone
};

}  // namespace aisle
