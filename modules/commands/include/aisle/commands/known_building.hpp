#pragma once
/// Buildings to be found in: learned ones, and maps that others have made.

#include <filesystem>

#include "aisle/commands/outcome.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// What a map's pixels say at a point of the map; unknown beyond them.
Floor floor_at(const PlanReading& map, const Vec2& p_map);

/// The walls and the floor that a map shows. A wall is a border of free floor with occupied cells behind it;
/// where floor borders on what nobody has seen, there is none.
/// Problem: it has more corners than any building.
Result<Building> building_of_map(const PlanReading& map, std::string name, Progress& progress);

/// The same of a map of map_server (YAML) or a Bee map. Warnings go to the console. Problem: it shows no
/// walls either.
Result<Building> read_map_building(const std::filesystem::path& path, Console& console);

/// Reads a building file (JSON), told by the name, or a map of others. Warnings go to the console.
Result<Building> read_known_building(const std::filesystem::path& file, Console& console);

}  // namespace aisle
