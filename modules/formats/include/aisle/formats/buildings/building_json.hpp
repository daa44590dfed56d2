#pragma once
/// What was learned of a building, as a small JSON file with one wall, landmark or piece of a route a line;
/// see docs/formats/building.md.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// Version 1 of the format. Coordinates to the millimetre; routes so that 1 km of them ends within a
/// millimetre. What is read from it and written again is the same text. Routes must have a name and a length.
std::string building_json(const Building& building);

/// Malformed JSON is a problem with its line, an unknown format, version, key or a bad value one with its key
/// path ("walls[3].start_m"). Plain or gzip.
Result<Building> read_building(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in problems.
Result<Building> parse_building(std::string_view text, const std::string& name);

}  // namespace aisle
