#pragma once

#include <filesystem>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct ShowBuildingOptions {
  std::filesystem::path building;  ///< a building file, or a map of map_server
  std::filesystem::path out;       ///< empty: nothing is drawn
  bool force = false;              ///< replace existing pictures
};

/// `aisle show BUILDING`: says what is known of a building, and draws it.
Result<Outcome> run_show_building(const ShowBuildingOptions& options, Console& console);

}  // namespace aisle
