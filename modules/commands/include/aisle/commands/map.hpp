#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

enum class MapRules {
  kPublished,  ///< C99's Algorithms 2 and 3 as published
  kRefined,
};

struct MapOptions {
  std::filesystem::path log;
  MapRules rules = MapRules::kRefined;
  RecordingOptions reading;
  std::optional<double> odometry_delay_s;  ///< of the odometry behind its scan; none: estimated from the log
  std::optional<std::filesystem::path> relations;  ///< file of known relative poses, for evaluation
  std::filesystem::path out;                       ///< output directory; empty: figures only
  bool force = false;
  MapMode map_mode = MapMode::kTrinary;  ///< of the map of cells
  bool stages = false;                   ///< add the figures of every stage
  ParameterSources parameters;
};

/// `aisle map LOG`: builds the wall map of a building from a recorded laser log.
Result<Outcome> run_map(const MapOptions& options, Console& console);

/// Every parameter of `aisle map` with its default.
Outcome map_parameters();

}  // namespace aisle
