#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "aisle/commands/outcome.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/simulation/buildings/maze_building.hpp"
#include "aisle/simulation/paths/round_trip.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

enum class PlanKind {
  kAny,        ///< detected from the file's content and name
  kSegments,   ///< wall-segment text
  kImage,      ///< PBM, PGM, PNG: dark is wall
  kDrawing,    ///< SVG, PDF, DXF: what is drawn is wall
  kMapServer,  ///< map_server YAML with its image
  kBeeMap,     ///< text of a Bee map
  kMaze,       ///< any of the maze formats: cells with walls on their sides
};

/// A plan and how to read it.
struct PlanOptions {
  std::filesystem::path plan;
  PlanKind from = PlanKind::kAny;
  double resolution_m = 0.05;     ///< side of a pixel of a kImage, of a cell that a kDrawing is drawn in
  std::optional<double> scale_m;  ///< length of the plan's unit: a pixel (goes before resolution_m), a point
  double solid_from_black = kSolidFromBlack;  ///< of kImage and kDrawing
  PlanTracingParams tracing;
  double speck_m = 0;  ///< what fits into a square of this side is removed, see clean_plan()
  MazeBuildingParams maze;
};

/// World with the walls of the plan that the options name, and with a start if the plan has one.
Result<World> world_of_plan(const PlanOptions& options, Console& console);

/// A world with a start and a tour, if there is room for a vehicle.
struct PlannedWorld {
  World world;
  double drivable_m2 = 0;  ///< floor where a vehicle fits
};
PlannedWorld with_tour(World world, const RoundTripParams& run, Console& console);

/// Whether the file exists and is a plan: no YAML, or a map_server YAML that names an image.
bool is_plan(const std::filesystem::path& file);

/// Detects the kind of a plan from its content and name; never kAny.
PlanKind plan_kind_of(const std::filesystem::path& name, std::string_view bytes);

}  // namespace aisle
