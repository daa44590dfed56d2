#include "aisle/maps/landmark_map.hpp"

#include <algorithm>
#include <utility>

namespace aisle {

std::size_t LandmarkMap::add(const Landmark& landmark) {
  const std::size_t index = landmarks_.size();
  landmarks_.push_back(landmark);
  index_.add({landmark.p_map, landmark.p_map}, static_cast<int>(index));
  return index;
}

void LandmarkMap::replace(std::size_t index, const Landmark& landmark) {
  landmarks_[index] = landmark;
  index_.add({landmark.p_map, landmark.p_map}, static_cast<int>(index));
}

void LandmarkMap::assign(std::vector<Landmark> landmarks) {
  landmarks_.clear();
  index_.clear();
  for (const Landmark& landmark : landmarks) add(landmark);
}

void LandmarkMap::within(const Vec2& p_map, double distance_m, std::vector<int>& indices) const {
  index_.query(p_map, p_map, distance_m, indices);
  std::erase_if(indices, [&](int i) {
    const Landmark& landmark = landmarks_[static_cast<std::size_t>(i)];
    return landmark.weight == 0 || (landmark.p_map - p_map).norm() > distance_m;
  });
}

}  // namespace aisle
