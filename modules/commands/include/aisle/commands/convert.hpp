#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "aisle/commands/outcome.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/simulation/buildings/maze_building.hpp"
#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/paths/round_trip.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"

namespace aisle {

enum class PlanKind {
  kAny,        ///< detected from the file's content and name
  kSegments,   ///< wall-segment text
  kImage,      ///< PBM, PGM, PNG: dark is wall
  kDrawing,    ///< SVG, PDF, DXF: what is drawn is wall
  kMapServer,  ///< map_server YAML with its image
  kMaze,       ///< any of the maze formats: cells with walls on their sides
};

struct ConvertOptions {
  std::filesystem::path plan;  ///< unused if `seed` is set
  PlanKind from = PlanKind::kAny;
  double resolution_m = 0.05;     ///< side of a pixel of a kImage, of a cell that a kDrawing is drawn in
  std::optional<double> scale_m;  ///< length of the plan's unit: a pixel (goes before resolution_m), a point
  double solid_from_black = kSolidFromBlack;  ///< of kImage and kDrawing
  PlanTracingParams tracing;
  double speck_m = 0;  ///< what fits into a square of this side is removed, see clean_plan()
  MazeBuildingParams maze;
  RoundTripParams run;
  std::optional<std::uint64_t> seed;  ///< makes a random building of this seed
  RandomBuildingRecipe recipe;
  bool dress = false;  ///< add doors, lamps and posters to a plan; random buildings have them
  std::filesystem::path out;
  bool force = false;
};

/// `aisle convert PLAN|--random SEED -o WORLD`: makes a world from a plan, or at random.
Result<Outcome> run_convert(const ConvertOptions& options, Console& console);

}  // namespace aisle
