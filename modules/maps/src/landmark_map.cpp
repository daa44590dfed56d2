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
  landmarks_ = std::move(landmarks);
  index_.clear();
  for (std::size_t i = 0; i < landmarks_.size(); ++i)
    index_.add({landmarks_[i].p_map, landmarks_[i].p_map}, static_cast<int>(i));
}

void LandmarkMap::within(const Vec2& p_map, double distance_m, std::vector<int>& indices) const {
  index_.query(p_map, p_map, distance_m, indices);
  std::erase_if(indices, [&](int i) {
    const Landmark& landmark = landmarks_[static_cast<std::size_t>(i)];
    return landmark.weight == 0 || (landmark.p_map - p_map).norm() > distance_m;
  });
}

}  // namespace aisle
