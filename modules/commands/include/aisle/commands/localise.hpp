#pragma once

#include <filesystem>
#include <optional>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

struct LocaliseOptions {
  std::filesystem::path log;
  std::filesystem::path building;  ///< a building file (JSON), or a map of map_server (YAML)
  RecordingOptions reading;
  std::optional<std::filesystem::path> relations;  ///< file of known relative poses, for evaluation
  std::optional<Pose2> T_map_hint;                 ///< where somebody says that the recording begins
  std::filesystem::path out;                       ///< TUM file of the poses; empty: not written
  bool force = false;
  ParameterSources parameters;
};

/// `aisle localise LOG --building B`: finds the vehicle of a recorded laser log in a known building, and
/// follows it.
Result<Outcome> run_localise(const LocaliseOptions& options, Console& console);

/// Every parameter of `aisle localise` with its default.
Outcome localise_parameters();

}  // namespace aisle
