#include "aisle/commands/convert.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/geometry/polyline.hpp"
#include "aisle/simulation/buildings/decoration.hpp"

namespace aisle {
namespace {

double to_decimetre(double length_m) {
  return std::round(length_m * 10) / 10;
}

Result<World> random_world(const ConvertOptions& options) {
  if (Problems problems = options.recipe.problems(); !problems.empty()) return problems;
  World world = random_building(options.recipe, Random(*options.seed));
  world.name = fmt::format("{}-{}", name_of(options.recipe.kind), *options.seed);
  return world;
}

}  // namespace

Result<Outcome> run_convert(const ConvertOptions& options, Console& console) {
  if (!options.force && std::filesystem::exists(options.out)) {
    return Problem{{options.out.string()}, "exists already; --force replaces it"};
  }
  Result<World> bare = options.seed ? random_world(options) : world_of_plan(options, console);
  if (!bare) return bare.problems();
  auto [world, drivable_m2] = with_tour(std::move(*bare), options.run, console);
  if (options.dress && !options.seed) dress(world, Random(1));
  if (Problems problems = write_whole_file(options.out, world_yaml(world)); !problems.empty())
    return problems;

  double walls_m = 0;
  for (const WallFace& wall : world.walls) walls_m += wall.floor_edge.length();
  Outcome outcome{.verb = "convert"};
  outcome.figures = {{"name", world.name},
                     {"seed", options.seed ? nlohmann::ordered_json(*options.seed) : nullptr},
                     {"walls", world.walls.size()},
                     {"walls_m", to_decimetre(walls_m)},
                     {"doors", world.doors.size()},
                     {"lamps", world.lamps.size()},
                     {"posters", world.posters.size()},
                     {"drivable_m2", to_decimetre(drivable_m2)},
                     {"tour_m", to_decimetre(polyline_length_m(world.tour))}};
  outcome.files["world"] = options.out.string();
  outcome.text = fmt::format("{}: {} walls, {:.0f} m; a tour of {:.0f} m\n", options.out.string(),
                             world.walls.size(), walls_m, polyline_length_m(world.tour));
  return outcome;
}

}  // namespace aisle
