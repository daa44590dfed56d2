#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/logs/carmen_log.hpp"

namespace aisle {

enum class MapRules {
  kPublished,  ///< C99's Algorithms 2 and 3 as they stand
  kRefined,
};

struct MapOptions {
  std::filesystem::path log;
  MapRules rules = MapRules::kRefined;
  CarmenOptions reading;
  std::optional<double> odometry_delay_s;  ///< none: found from the log
  std::optional<std::filesystem::path> relations;
  std::filesystem::path out;  ///< empty: figures only
  bool force = false;
  bool stages = false;  ///< figures of every stage as well
  ParameterSources parameters;
};

/// `aisle map LOG`: a building's wall map from a recorded laser log.
Result<Outcome> run_map(const MapOptions& options, Console& console);

/// Every parameter of `aisle map` with its default.
Outcome map_parameters();

}  // namespace aisle
