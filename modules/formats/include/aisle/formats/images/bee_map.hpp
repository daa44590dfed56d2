#pragma once
/// Maps of CMU's course on localisation, as text; see docs/formats/bee.md.

#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/images/plan_image.hpp"

namespace aisle {

/// The plan that a Bee map shows. Its frame `world` is the map's: the corner of cell (0, 0) is the origin.
/// Every problem has its line.
Result<PlanReading> parse_bee_map(std::string_view text, const std::string& name);

/// Whether a text with these first bytes is such a map.
bool begins_bee_map(std::string_view head);

/// Reads a map of cells that somebody else has made: of map_server (YAML and image) or a Bee map, told by
/// content.
Result<PlanReading> read_cell_map(const std::filesystem::path& path);

}  // namespace aisle
