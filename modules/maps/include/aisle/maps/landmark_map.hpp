#pragma once
/// The learned model of C98: vertical lines of the building as points on its floor.

#include <limits>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/maps/cell_index.hpp"

namespace aisle {

struct Landmark {
  Vec2 p_map = Vec2::Zero();
  Mat2 covariance = Mat2::Zero();  ///< of its position, from its sightings
  double mass = 0;                 ///< sum of the confidence weights of its sightings (C98 eq. (16), (17))
  double weight = 1;               ///< confidence: 1 is the map's mean (C98 eq. (18))
  int sightings = 0;               ///< images in which it was seen
  int passes = 0;                  ///< runs on which it was seen
  Vec2 seen_from = Vec2::Zero();   ///< unit vector in `map` towards where it was seen from; zero: unknown
  double seen_near_m = 0;          ///< least distance that it was seen from ...
  double seen_far_m = std::numeric_limits<double>::infinity();  ///< ... and the greatest; infinite: unknown
  bool brighter_right = false;  ///< brighter on its right side, from wherever it is seen
};

/// Landmarks with a spatial index: lookups cost the same whatever the size of the building.
class LandmarkMap {
 public:
  const std::vector<Landmark>& all() const { return landmarks_; }
  const Landmark& operator[](std::size_t i) const { return landmarks_[i]; }
  std::size_t size() const { return landmarks_.size(); }
  bool empty() const { return landmarks_.empty(); }

  /// @return its index
  std::size_t add(const Landmark& landmark);
  /// Replaces the landmark at an index.
  void replace(std::size_t index, const Landmark& landmark);
  /// Leaves a gap (weight 0), so that indices stay; `within` skips it.
  void remove(std::size_t index) { landmarks_[index].weight = 0; }
  /// Replaces all landmarks; indices change.
  void assign(std::vector<Landmark> landmarks);

  /// Replaces `indices` by those of all landmarks within a distance of a point, in ascending order.
  void within(const Vec2& p_map, double distance_m, std::vector<int>& indices) const;

 private:
  std::vector<Landmark> landmarks_;
  CellIndex index_;
};

}  // namespace aisle
