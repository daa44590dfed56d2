#pragma once

#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/cell_index.hpp"
#include "aisle/vehicle/floor_in_image.hpp"

namespace aisle {

/// The floor that was in a camera's view while routes were taught. Of what stands elsewhere the map says
/// nothing: on a return path, what is beyond the place from which a route began was behind the vehicle.
class TaughtView {
 public:
  explicit TaughtView(const FloorInImage& floor) : floor_(floor) {}

  /// The route was driven along its path, the camera ahead.
  void add(const Path& route);

  /// Whether the point of the floor was in view from some place of a route, at most 7 m before the vehicle.
  /// What stood before it is left out of account. The cost does not grow with the building.
  bool shows(const Vec2& p_map);

 private:
  bool shows_from(const Pose2& T_map_vehicle, const Vec2& p_map) const;

  FloorInImage floor_;  ///< of the camera
  std::vector<Pose2> T_map_taught_;
  CellIndex index_;        ///< of these
  std::vector<int> near_;  ///< of them to the point that is asked for
};

}  // namespace aisle
