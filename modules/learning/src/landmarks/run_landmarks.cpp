#include "landmarks/run_landmarks.hpp"

#include <algorithm>
#include <numeric>

namespace aisle {

PresentLandmarks::PresentLandmarks(std::span<const RunLandmark> all)
    : all_(all), by_first_cycle_(all.size()) {
  std::iota(by_first_cycle_.begin(), by_first_cycle_.end(), std::size_t{0});
  std::stable_sort(by_first_cycle_.begin(), by_first_cycle_.end(),
                   [&](std::size_t a, std::size_t b) { return all_[a].first_cycle < all_[b].first_cycle; });
}

const LandmarkMap& PresentLandmarks::at(std::size_t cycle) {
  while (map_.size() < all_.size() && all_[original(map_.size())].first_cycle <= cycle)
    present_.push_back(map_.add(all_[original(map_.size())].landmark));
  std::erase_if(present_, [&](std::size_t i) {
    const bool is_gone = all_[original(i)].last_cycle < cycle;
    if (is_gone) map_.remove(i);
    return is_gone;
  });
  return map_;
}

}  // namespace aisle
