#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/maps/landmark_map.hpp"
#include "aisle/maps/route.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

/// Everything that was learned of one building. Every part may be empty.
struct Building {
  std::string name;
  bool has_dominant_direction = false;  ///< most walls lie on one orthogonal frame, the axes of `map`
  WallMap walls;
  std::optional<CameraDescription> camera;  ///< that the landmarks were seen with; present if there are any
  LandmarkMap landmarks;
  std::vector<Route> routes;
};

}  // namespace aisle
