#include "aisle/commands/show_building.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/known_building.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/report/building_picture.hpp"

namespace aisle {
namespace {

using OrderedJson = nlohmann::ordered_json;

double free_m2(const Building& building) {
  return building.floor ? building.floor->free_m2() : 0;
}

/// The methods that can drive in it.
std::vector<std::string> drivable_by(const Building& building) {
  std::vector<std::string> verbs;
  if (building.floor) verbs.insert(verbs.end(), {"go", "patrol"});
  const auto has_route = [&](auto is_so) {
    return std::any_of(building.routes.begin(), building.routes.end(), is_so);
  };
  if (!building.landmarks.empty() && !building.routes.empty())
    verbs.emplace_back("navigate --method landmarks");
  if (has_route([](const Route& route) { return !route.sections.empty(); }))
    verbs.emplace_back("navigate --method sections");
  if (has_route([](const Route& route) { return route.room.has_value(); }))
    verbs.emplace_back("navigate --method rooms");
  return verbs;
}

OrderedJson zones_of(const Building& building) {
  OrderedJson zones = OrderedJson::array();
  for (const Zone& zone : building.zones) zones.push_back(words_for(zone));
  return zones;
}

Outcome described(const Building& building) {
  Outcome outcome{.verb = "show"};
  OrderedJson places = OrderedJson::array(), routes = OrderedJson::array();
  std::vector<std::string> place_names;
  for (const MapPlace& place : building.places) {
    places.push_back(place.name);
    place_names.push_back(place.name);
  }
  for (const Route& route : building.routes)
    routes.push_back({{"name", route.name}, {"length_m", rounded(route.path.length_m(), 2)}});
  const std::vector<std::string> verbs = drivable_by(building);
  outcome.figures = {{"name", building.name},
                     {"walls", building.walls.walls.size()},
                     {"wall_m", rounded(building.walls.length_m(), 2)},
                     {"free_m2", rounded(free_m2(building), 1)},
                     {"corridors", building.corridors.corridors.size()},
                     {"corridors_m", rounded(building.corridors.length_m(), 1)},
                     {"landmarks", building.landmarks.size()},
                     {"routes", routes},
                     {"places", places},
                     {"barriers", building.barriers.size()},
                     {"zones", zones_of(building)},
                     {"driven_by", verbs}};
  outcome.text = fmt::format(
      "{}: {:.1f} m2 of free floor\n"
      "  walls: {} ({:.1f} m), corridors: {} ({:.1f} m), landmarks: {}, lines and zones drawn by a person: "
      "{} and {}\n",
      building.name, free_m2(building), building.walls.walls.size(), building.walls.length_m(),
      building.corridors.corridors.size(), building.corridors.length_m(), building.landmarks.size(),
      building.barriers.size(), building.zones.size());
  for (const Zone& zone : building.zones) outcome.text += fmt::format("  {}\n", words_for(zone));
  if (!place_names.empty()) outcome.text += fmt::format("  places: {}\n", fmt::join(place_names, ", "));
  for (const Route& route : building.routes)
    outcome.text += fmt::format("  route '{}' of {:.1f} m\n", route.name, route.path.length_m());
  outcome.text += verbs.empty() ? "  no mission can be driven in it\n"
                                : fmt::format("  driven in by: {}\n", fmt::join(verbs, ", "));
  return outcome;
}

}  // namespace

Result<Outcome> run_show_building(const ShowBuildingOptions& options, Console& console) {
  const auto directory =
      OutputDirectory::open_if_named(options.out, options.force, {"building.svg", "building.png"});
  if (!directory) return directory.problems();
  const auto building = read_known_building(options.building, console);
  if (!building) return building.problems();
  Outcome outcome = described(*building);
  if (!*directory) return outcome;
  const BuildingPicture picture{
      .building = *building,
      .title = building->name,
      .caption = fmt::format("{:.1f} m2 of free floor; places: {}, routes: {}", free_m2(*building),
                             building->places.size(), building->routes.size())};
  auto written = (*directory)
                     ->write({{"picture_svg", "building.svg", svg(picture)},
                              {"picture_png", "building.png", png(picture)}});
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  outcome.text += fmt::format("see {}\n", outcome.files["picture_png"]);
  return outcome;
}

}  // namespace aisle
