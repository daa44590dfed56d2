#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "aisle/commands/outcome.hpp"
#include "aisle/simulation/buildings/maze_building.hpp"
#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/paths/round_trip.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"

namespace aisle {

enum class PlanKind {
  kAny,        ///< known from the file's content and name
  kSegments,   ///< wall-segment text
  kImage,      ///< PBM, PGM, PNG: dark is wall
  kMapServer,  ///< map_server's YAML with its image
  kMaze,       ///< cells with walls on their sides, in any of the maze formats
};

struct ConvertOptions {
  std::filesystem::path plan;  ///< not used if there is a seed
  PlanKind from = PlanKind::kAny;
  double resolution_m = 0.05;  ///< side of a pixel of kPicture
  PlanTracingParams tracing;
  double speck_m = 0.1;  ///< what is left out of a plan of cells, see clean_plan()
  MazeBuildingParams maze;
  RoundTripParams run;
  std::optional<std::uint64_t> seed;  ///< of a random building
  RandomBuildingRecipe recipe;
  bool dress = false;  ///< doors, lamps and posters for a plan; random buildings have them
  std::filesystem::path out;
  bool force = false;
};

/// `aisle convert PLAN|--random SEED -o WORLD`: a world to drive in from a plan, or by chance.
Result<Outcome> run_convert(const ConvertOptions& options, Console& console);

}  // namespace aisle
