#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/maps/section.hpp"

namespace aisle {

/// The floor point of a vertical line, as seen from a route's start.
struct StartSighting {
  Vec2 p_vehicle = Vec2::Zero();
  bool brighter_right = false;  ///< brighter on its right side, as seen
};

/// A taught path.
struct Route {
  std::string name;                       ///< unique in its building
  Path path;                              ///< in `map`, base_link; as driven, smoothed
  std::vector<StartSighting> start_view;  ///< from the path's start
  SectionList sections;                   ///< L03; if not empty, the path is made from them
  std::optional<RoomRoute> room;          ///< L96
};

}  // namespace aisle
