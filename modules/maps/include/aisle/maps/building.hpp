#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/maps/barrier.hpp"
#include "aisle/maps/corridor_graph.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/landmark_map.hpp"
#include "aisle/maps/route.hpp"
#include "aisle/maps/wall_direction.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/maps/zone.hpp"
#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

/// A named pose that the vehicle can be sent to.
struct MapPlace {
  std::string name;  ///< unique in its building
  Pose2 T_map_place;
  bool has_heading = true;  ///< false: how the vehicle stands there does not matter, and theta is 0
};

/// The place where an exploration starts and ends, and where missions start.
inline constexpr const char* kHomePlace = "home";

/// Everything that was learned of one building. Every part may be empty.
struct Building {
  std::string name;
  bool has_dominant_direction = false;  ///< most walls lie on one orthogonal frame, the axes of `map`
  WallMap walls;
  std::optional<CameraDescription>
      camera;  ///< the one that the landmarks were seen with; present if there are any
  LandmarkMap landmarks;
  std::vector<WallDirection> wall_directions;  ///< from where landmarks were learned
  std::vector<Route> routes;
  CorridorGraph corridors;
  std::vector<MapPlace> places;
  std::vector<Barrier> barriers;
  std::vector<Zone> zones;
  std::optional<FloorGrid> floor;  ///< as it was seen
};

/// The pose of the place "home"; without one, the origin of `map`.
Pose2 home_of(const Building& building);

/// All lines that a vehicle must not cross: the barriers, and the outlines of keep-out zones.
std::vector<Barrier> lines_not_crossed(const Building& building);

}  // namespace aisle
