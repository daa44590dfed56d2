#include "aisle/commands/plan_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <utility>

#include "aisle/formats/file_contents.hpp"
#include "aisle/formats/images/bee_map.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/images/plan_drawing.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/formats/mazes/maze_file.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/simulation/plans/free_sides.hpp"
#include "aisle/simulation/plans/plan_symbols.hpp"

namespace aisle {
namespace {

constexpr std::size_t kBytesMax = std::size_t{128} << 20;
constexpr int kMazeSizeMax = 512;

/// "x1 y1 x2 y2" and perhaps a word: no line of a maze looks like that.
bool is_wall_segment(const std::string& line) {
  std::istringstream fields(line);
  double number = 0;
  for (int i = 0; i < 4; ++i) {
    if (!(fields >> number)) return false;
  }
  return !(fields >> number);
}

bool begins_with_wall_segment(std::string_view bytes) {
  std::istringstream lines{std::string(bytes.substr(0, 4096))};
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line[0] != '#') return is_wall_segment(line);
  }
  return false;
}

/// "at pixel (u, v)", as image editors show it.
std::string pixel_of(const CellBox& box, const FloorPlan& plan) {
  return fmt::format("at pixel ({}, {})", box.x, plan.height - box.y - box.height);
}

/// Opens the doors that are drawn and says what was taken for what.
void read_symbols(FloorPlan& plan, const std::string& name, Console& console) {
  const auto [doors, marks] = open_drawn_doors(plan);
  if (!doors.empty()) {
    console.warn(fmt::format("{}: {} drawn as leaf and arc, the first {}, taken as open", name,
                             doors.size() == 1 ? "a door" : fmt::format("{} doors", doors.size()),
                             pixel_of(doors.front(), plan)));
  }
  if (marks.empty()) return;
  int side = 0;
  for (const CellBox& mark : marks) side = std::max({side, mark.width, mark.height});
  console.warn(
      fmt::format("{}: {} small strokes that stand free, such as letters, the first {}, count as walls; "
                  "--speck {:.3g} removes them",
                  name, marks.size(), pixel_of(marks.front(), plan), side * plan.cell_m));
}

Result<World> world_of_floor(Result<PlanReading> read, const PlanOptions& options, Console& console) {
  if (!read) return read.problems();
  const std::string name = options.plan.string();
  warn_of(read->warnings, console);
  FloorPlan& plan = read->plan;
  if (options.from != PlanKind::kMapServer && options.from != PlanKind::kBeeMap)
    read_symbols(plan, name, console);
  if (const int specks = clean_plan(plan, {.speck_m = options.speck_m}); specks > 0)
    console.warn(fmt::format("{}: {} specks removed, as --speck says", name, specks));
  const auto walls = trace_plan(plan, options.tracing, console.progress);
  if (!walls || walls->size() > kWorldWallsMax) {
    return Problem{
        {name},
        fmt::format("makes more than {} walls, the most of a world; --speck removes what is small, "
                    "--tolerance straightens, a smaller copy has less detail",
                    kWorldWallsMax)};
  }
  World world;
  world.walls.reserve(walls->size());
  for (const Segment2& wall : *walls) world.walls.push_back({.floor_edge = wall});
  if (world.walls.empty()) return Problem{{name}, "shows no free floor"};
  return world;
}

Result<World> world_of_maze(std::string_view bytes, const PlanOptions& options, Console& console) {
  const Result<MazeFile> maze = parse_maze(bytes, options.plan.string());
  if (!maze) return maze.problems();
  if (std::max(maze->world.width(), maze->world.height()) > kMazeSizeMax) {
    return Problem{{options.plan.string()},
                   fmt::format("has {} x {} cells; at most {} columns and rows are built",
                               maze->world.width(), maze->world.height(), kMazeSizeMax)};
  }
  if (!maze->has_start) {
    console.warn(fmt::format("{}: has no start; the start is cell ({}, {})", options.plan.string(),
                             maze->world.start.x, maze->world.start.y));
  }
  return build_maze(maze->world, options.maze);
}

Result<World> world_of_segments(std::string_view bytes, const std::string& name) {
  Result<World> world = parse_wall_segments(bytes, name);
  if (!world) return world;
  std::vector<Segment2> floor_edges;
  for (const WallFace& wall : world->walls) floor_edges.push_back(wall.floor_edge);
  floor_edges = with_free_sides_left(floor_edges);
  for (std::size_t i = 0; i < floor_edges.size(); ++i) world->walls[i].floor_edge = floor_edges[i];
  return world;
}

Problem no_plan(const std::string& name, const std::string& contents) {
  const bool is_building = contents.find("building") != std::string::npos;
  return {{name},
          fmt::format("is {}; {}plans are images (PNG, JPEG, PGM, PBM, PPM, BMP, TIFF, WebP), drawings (SVG, "
                      "PDF, DXF), map_server YAML, Bee maps, wall segments and mazes (docs/formats/plan.md)",
                      contents, is_building ? "`aisle go` drives in one. " : "")};
}

Result<World> walls_of_plan(PlanOptions options, Console& console) {
  const Result<std::string> bytes = read_whole_file(options.plan, kBytesMax);
  if (!bytes) return bytes.problems();
  const std::string name = options.plan.string();
  if (options.from == PlanKind::kAny) {
    options.from = plan_kind_of(options.plan, *bytes);
    const auto contents = known_contents(*bytes);
    if (options.from == PlanKind::kMaze && contents) return no_plan(name, *contents);
  }
  switch (options.from) {
    case PlanKind::kSegments:
      return world_of_segments(*bytes, name);
    case PlanKind::kImage:
      return world_of_floor(parse_plan_image(*bytes, name, options.scale_m.value_or(options.resolution_m),
                                             options.solid_from_black),
                            options, console);
    case PlanKind::kDrawing:
      return world_of_floor(
          parse_plan_drawing(*bytes, name, {options.resolution_m, options.scale_m}, options.solid_from_black),
          options, console);
    case PlanKind::kMapServer:
      return world_of_floor(read_map_server(options.plan), options, console);
    case PlanKind::kBeeMap:
      return world_of_floor(parse_bee_map(*bytes, name), options, console);
    case PlanKind::kMaze:
    case PlanKind::kAny:
      break;
  }
  return world_of_maze(*bytes, options, console);
}

bool is_yaml(const std::filesystem::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

}  // namespace

PlanKind plan_kind_of(const std::filesystem::path& name, std::string_view bytes) {
  using namespace std::string_view_literals;
  static constexpr std::array kImages = {"P1"sv, "P2"sv,      "P3"sv,           "P4"sv,    "P5"sv,   "P6"sv,
                                         "BM"sv, "\x89PNG"sv, "\xff\xd8\xff"sv, "II*\0"sv, "MM\0*"sv};
  const bool is_webp = bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP");
  if (is_webp || std::any_of(kImages.begin(), kImages.end(),
                             [&](std::string_view magic) { return bytes.starts_with(magic); })) {
    return PlanKind::kImage;
  }
  if (drawing_kind_of(bytes)) return PlanKind::kDrawing;
  if (begins_bee_map(bytes)) return PlanKind::kBeeMap;
  if (is_yaml(name)) return PlanKind::kMapServer;
  return begins_with_wall_segment(bytes) ? PlanKind::kSegments : PlanKind::kMaze;
}

Result<World> world_of_plan(const PlanOptions& options, Console& console) {
  Result<World> world = walls_of_plan(options, console);
  if (world) world->name = options.plan.stem().string();
  return world;
}

PlannedWorld with_tour(World world, const RoundTripParams& params, Console& console) {
  auto run = plan_round_trip(world, params, console.progress);
  if (!run) {
    console.warn(
        fmt::format("{}: no room for a vehicle {:g} m wide: the world has neither a start nor a tour",
                    world.name, params.vehicle_width_m));
    return {std::move(world), 0};
  }
  if (run->shut_off) {
    const auto& [share, largest_m2, p_world] = *run->shut_off;
    console.warn(
        fmt::format("{}: {:.2g} % of the floor where a vehicle {:g} m wide fits cannot be reached from the "
                    "start; the largest such part, {:.3g} m2, is at ({:.2f}, {:.2f}) m",
                    world.name, 100 * share, params.vehicle_width_m, largest_m2, p_world.x(), p_world.y()));
  }
  if (!world.start) world.start = run->T_world_start;
  if (world.tour.empty() && run->tour.size() > 1) world.tour = std::move(run->tour);
  return {std::move(world), run->drivable_m2};
}

bool is_plan(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false;
  if (!is_yaml(file)) return true;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("image:")) return true;
  }
  return false;
}

}  // namespace aisle
