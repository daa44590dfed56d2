#include "aisle/commands/convert_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "aisle/commands/known_building.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/learning/corridors/corridor_tracing.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"

namespace aisle {
namespace {

/// Outlines of the zones that a mask keeps the vehicle out of. What lies beyond the mask is no zone.
Result<std::vector<Barrier>> outlines_of(const PlanReading& mask, const std::string& name,
                                         Progress& progress) {
  FloorPlan zones = mask.plan;
  for (std::size_t i = 0; i < zones.solid.size(); ++i) {
    const bool is_unknown = !mask.unseen.empty() && mask.unseen[i] != 0;
    zones.solid[i] = zones.solid[i] == 0 || is_unknown ? 1 : 0;
  }
  const auto outlines = trace_plan(zones, {}, progress);
  if (!outlines) return Problem{{name}, "has zones with more than a million sides"};
  std::vector<Barrier> barriers;
  barriers.reserve(outlines->size());
  for (const Segment2& outline : *outlines) barriers.push_back({Barrier::Kind::kKeepOut, outline});
  return barriers;
}

/// The floor as if the zones of a mask were obstacles.
FloorGrid without_zones(FloorGrid floor, const PlanReading& mask) {
  const FloorBox known = floor.known();
  for (int y = known.low.y; y < known.end.y; ++y) {
    for (int x = known.low.x; x < known.end.x; ++x) {
      const FloorCell cell{x, y};
      if (floor.at(cell) == Floor::kFree && floor_at(mask, floor.centre(cell)) == Floor::kOccupied)
        floor.set(cell, Floor::kOccupied);
    }
  }
  return floor;
}

/// Adds a home at the map's origin, where mapping began, unless there is one.
void add_home(std::vector<MapPlace>& places) {
  const auto is_home = [](const MapPlace& place) { return place.name == kHomePlace; };
  if (std::none_of(places.begin(), places.end(), is_home)) places.insert(places.begin(), {kHomePlace, {}});
}

Problems check_places(const std::vector<MapPlace>& places, const FloorGrid& floor, const FloorGrid& allowed) {
  Problems problems;
  for (const MapPlace& place : places) {
    const std::string& name = place.name;
    const Vec2 p_map = place.T_map_place.position();
    if (allowed.at(p_map) == Floor::kFree) continue;
    const char* const why = floor.at(p_map) == Floor::kFree ? "lies in a keep-out zone"
                                                            : "is not on floor that the map shows free";
    problems.push_back(
        {{"--place"}, fmt::format("'{}' at {:.6g},{:.6g} {}", name, p_map.x(), p_map.y(), why)});
    if (name == kHomePlace)
      problems.back().what +=
          "; missions begin at home, by default the map's origin: "
          "--place home=x,y,heading_deg";
  }
  return problems;
}

/// Home, places, barriers, and the corridors that can be driven from home.
Problems furnish(Building& building, const ConvertMapOptions& options, Console& console) {
  building.places = options.places;
  add_home(building.places);
  FloorGrid allowed = *building.floor;
  if (!options.keep_out.empty()) {
    const auto mask = read_map_server(options.keep_out);
    if (!mask) return mask.problems();
    warn_of(mask->warnings, console);
    auto barriers = outlines_of(*mask, options.keep_out.string(), console.progress);
    if (!barriers) return barriers.problems();
    if (barriers->empty()) console.warn(options.keep_out.string() + ": has no occupied cell: no zone");
    building.barriers = std::move(*barriers);
    allowed = without_zones(std::move(allowed), *mask);
  }
  if (Problems problems = check_places(building.places, *building.floor, allowed); !problems.empty())
    return problems;
  building.corridors = trace_corridors(allowed, home_of(building).position(), {});
  if (building.corridors.nodes.empty())
    return {{{"--place"},
             fmt::format("'{}' is where no vehicle can drive: within a metre of it, all "
                         "floor is nearer than {:g} m to something",
                         kHomePlace, CorridorTracingParams{}.clearance_min_m)}};
  return {};
}

Outcome outcome_of(const Building& building, const std::string& out) {
  Outcome outcome{.verb = "convert"};
  outcome.figures = {{"name", building.name},
                     {"walls", building.walls.walls.size()},
                     {"floor_m2", rounded(building.floor->free_m2(), 1)},
                     {"corridors", building.corridors.corridors.size()},
                     {"corridors_m", rounded(building.corridors.length_m(), 1)},
                     {"places", building.places.size()},
                     {"barriers", building.barriers.size()}};
  outcome.files["building"] = out;
  outcome.text = fmt::format(
      "{}: {} walls, {:.0f} m2 of free floor, {:.0f} m of corridors, {} places, {} "
      "keep-out lines\n",
      out, building.walls.walls.size(), building.floor->free_m2(), building.corridors.length_m(),
      building.places.size(), building.barriers.size());
  return outcome;
}

}  // namespace

Result<Outcome> run_convert_map(const ConvertMapOptions& options, Console& console) {
  const std::string out = options.out.string();
  if (!options.force && std::filesystem::exists(options.out))
    return Problem{{out}, "exists already; --force replaces it"};
  auto building = read_map_building(options.map, console);
  if (!building) return building.problems();
  if (building->walls.walls.empty()) return Problem{{options.map.string()}, "shows no walls"};
  if (Problems problems = furnish(*building, options, console); !problems.empty()) return problems;
  const std::string json = building_json(*building);
  if (const auto read = parse_building(json, out); !read) return read.problems();
  if (Problems problems = write_whole_file(options.out, json); !problems.empty()) return problems;
  return outcome_of(*building, out);
}

}  // namespace aisle
