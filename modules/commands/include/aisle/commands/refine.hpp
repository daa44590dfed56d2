#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

struct RefineOptions {
  std::filesystem::path building;
  /// Taken in this order: sessions along the building's routes, if it has landmarks; else recordings of a
  /// laser scanner, anywhere in it.
  std::vector<std::filesystem::path> trips;
  RecordingOptions reading;         ///< of laser recordings
  std::optional<Pose2> T_map_hint;  ///< where somebody says that a laser recording begins
  std::filesystem::path out;        ///< output directory; empty: figures only
  bool force = false;
  ParameterSources parameters;
};

/// `aisle refine BUILDING TRIP...`: refines a building with more trips: its landmarks, if it has any (C98
/// Algorithm 4), else its walls and floor.
Result<Outcome> run_refine(const RefineOptions& options, Console& console);

/// Every parameter of `aisle refine` with its default.
Outcome refine_parameters();

}  // namespace aisle
