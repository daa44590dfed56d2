#pragma once

#include <filesystem>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

struct ConvertMapOptions {
  std::filesystem::path map;       ///< YAML file of map_server
  std::filesystem::path keep_out;  ///< another one, in the same frame: its occupied cells; empty: none
  std::vector<MapPlace> places;    ///< without a home, it is the map's origin
  std::filesystem::path out;
  bool force = false;
};

/// `aisle convert MAP --building -o BUILDING`: makes a building to drive in of a map that others made.
Result<Outcome> run_convert_map(const ConvertMapOptions& options, Console& console);

}  // namespace aisle
