#pragma once
/// The parts of a building file. Each is described where it is implemented, in <part>_json.cpp.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/maps/building.hpp"
#include "buildings/json_fields.hpp"

namespace aisle {

JsonPart walls_part(std::string_view key, WallMap& map);

/// The keys of a vehicle file's camera and its name.
JsonPart camera_part(std::string_view key, std::optional<CameraDescription>& camera);

JsonPart landmarks_part(std::string_view key, LandmarkMap& map);

JsonPart wall_directions_part(std::string_view key, std::vector<WallDirection>& directions);

/// Empty and duplicate names are problems, and so are routes that lead nowhere. Writing one without a name or
/// a length throws std::invalid_argument.
JsonPart routes_part(std::string_view key, std::vector<Route>& routes);

/// What drives a route through a room.
JsonPart room_part(std::string_view key, std::optional<RoomRoute>& room);

/// Corridors that do not begin and end at their nodes, or whose length does not match their path, are
/// problems. Left out without nodes.
JsonPart corridors_part(std::string_view key, CorridorGraph& graph);

/// Empty and duplicate names are problems.
JsonPart places_part(std::string_view key, std::vector<MapPlace>& places);

JsonPart barriers_part(std::string_view key, std::vector<Barrier>& barriers);

/// Outlines without area, slow zones without a speed and one-way zones without a direction are problems.
JsonPart zones_part(std::string_view key, std::vector<Zone>& zones);

/// Rows of cells from the bottom up, each as runs of equal cells.
JsonPart floor_part(std::string_view key, std::optional<FloorGrid>& floor);

/// The value of that part.
std::string floor_json(const FloorGrid& floor);

/// Which side of a vertical line is the brighter one: "right" or "left".
ObjectField brighter_field(std::string_view key, bool& is_right);

}  // namespace aisle
