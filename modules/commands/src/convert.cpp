#include "aisle/commands/convert.hpp"

#include <fmt/format.h>

#include <cmath>

#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/world_yaml.hpp"
#include "aisle/geometry/polyline.hpp"
#include "aisle/simulation/dressing.hpp"
#include "plan_reading.hpp"

namespace aisle {
namespace {

constexpr std::size_t kWallsMax = 200'000;  ///< of a world that can be read again

double to_decimetre(double length_m) {
  return std::round(length_m * 10) / 10;
}

/// Gives the world a start and a tour where it has none; returns where a vehicle can be [m^2].
double add_tour(World& world, const ConvertOptions& options, Console& console) {
  const auto trip = plan_round_trip(world, options.trip, console.progress);
  if (!trip) {
    console.warn(fmt::format("{}: no room for a vehicle {:g} m wide: the world has neither start nor tour",
                             world.name, options.trip.vehicle_width_m));
    return 0;
  }
  if (!world.start) world.start = trip->T_world_start;
  if (world.tour.empty() && trip->tour.size() > 1) world.tour = trip->tour;
  return trip->drivable_m2;
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
  Result<World> world = options.seed ? random_world(options) : world_of_plan(options, console);
  if (!world) return world.problems();
  if (world->walls.size() > kWallsMax) {
    return Problem{
        {world->name},
        fmt::format("makes {} walls; a world has at most {} (a larger --tolerance or --speck makes fewer)",
                    world->walls.size(), kWallsMax)};
  }
  const double drivable_m2 = add_tour(*world, options, console);
  if (options.dress && !options.seed) dress(*world, Random(1));
  if (Problems problems = write_whole_file(options.out, world_yaml(*world)); !problems.empty())
    return problems;

  double walls_m = 0;
  for (const WallFace& wall : world->walls) walls_m += wall.foot.length();
  Outcome outcome{.verb = "convert"};
  outcome.figures = {{"name", world->name},
                     {"seed", options.seed ? nlohmann::ordered_json(*options.seed) : nullptr},
                     {"walls", world->walls.size()},
                     {"walls_m", to_decimetre(walls_m)},
                     {"doors", world->doors.size()},
                     {"lamps", world->lamps.size()},
                     {"posters", world->posters.size()},
                     {"drivable_m2", to_decimetre(drivable_m2)},
                     {"tour_m", to_decimetre(polyline_length_m(world->tour))}};
  outcome.files["world"] = options.out.string();
  outcome.text = fmt::format("{}: {} walls, {:.0f} m; a tour of {:.0f} m\n", options.out.string(),
                             world->walls.size(), walls_m, polyline_length_m(world->tour));
  return outcome;
}

}  // namespace aisle
