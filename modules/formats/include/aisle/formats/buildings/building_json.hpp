#pragma once
/// The learned map of a building as a small JSON file, with one wall, landmark or piece of a route per line;
/// see docs/formats/building.md.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// Writes the newest version of the format. Coordinates are rounded to the millimetre; routes have enough
/// digits that the end of a 1 km route is off by less than a millimetre. Reading the text and writing it
/// again gives the same text. @throws std::invalid_argument if a route has no name or no length
std::string building_json(const Building& building);

/// Malformed JSON is a problem with its line number; an unknown format, version or key, or a bad value, is a
/// problem with its key path ("walls[3].start_m"). Plain or gzip.
Result<Building> read_building(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<Building> parse_building(std::string_view text, const std::string& name);

}  // namespace aisle
