#pragma once

#include <filesystem>

#include "aisle/core/result.hpp"
#include "aisle/formats/images/plan_image.hpp"

namespace aisle {

/// Reads a map of cells that somebody else has made: of map_server (YAML and image) or a Bee map, told by
/// content. Its frame `world` is the map's.
Result<PlanReading> read_cell_map(const std::filesystem::path& path);

}  // namespace aisle
