#pragma once

#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/cell_index.hpp"
#include "aisle/vehicle/floor_in_image.hpp"

namespace aisle {

/// The floor that was in a camera's view while routes were taught. The map says nothing about anything
/// elsewhere: on a return path, what lies beyond the route's start was behind the vehicle when it was taught.
class TaughtView {
 public:
  explicit TaughtView(const FloorInImage& floor) : floor_(floor) {}

  /// Adds a route that was driven along its path, with the camera looking ahead.
  void add(const Path& route);

  /// Whether a point of the floor was in view from some place of a route, at most 7 m away. Occlusion is not
  /// considered. The cost does not grow with the building.
  bool shows(const Vec2& p_map);

 private:
  bool shows_from(const Pose2& T_map_vehicle, const Vec2& p_map) const;

  FloorInImage floor_;
  std::vector<Pose2> T_map_taught_;  ///< vehicle poses along the routes
  CellIndex index_;                  ///< of these poses
  std::vector<int> near_;            ///< those near the point in question; kept for its memory
};

}  // namespace aisle
