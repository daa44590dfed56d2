#include "merging/changes_figures.hpp"

#include <fmt/format.h>

#include "aisle/core/rounded.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(const Vec2& p) {
  return {rounded(p.x(), 3), rounded(p.y(), 3)};
}

const char* word_for(WallChange change) {
  switch (change) {
    case WallChange::kKept:
      return "kept";
    case WallChange::kNew:
      return "new";
    case WallChange::kGone:
      return "gone";
    case WallChange::kMoved:
      return "moved";
    case WallChange::kNotCompared:
      break;
  }
  return "not compared";
}

/// Each wall that has changed, once: what has moved as the new map shows it.
Json changed_walls(const BuildingChanges& changes) {
  Json walls = Json::array();
  for (const ChangedWall& wall : changes.walls) {
    const bool is_moved = wall.change == WallChange::kMoved;
    const bool counts = wall.change == WallChange::kNew || wall.change == WallChange::kGone;
    if (!counts && !(is_moved && wall.is_of_new)) continue;
    walls.push_back({{"change", word_for(wall.change)},
                     {"start_m", point_json(wall.segment.start)},
                     {"end_m", point_json(wall.segment.end)}});
    if (is_moved) walls.back()["moved_m"] = rounded(wall.moved_m, 3);
  }
  return walls;
}

Json changed_doors(const BuildingChanges& changes) {
  Json doors = Json::array();
  for (const DoorChange& door : changes.doors)
    doors.push_back({{"now", door.is_open ? "open" : "shut"},
                     {"at_m", point_json(door.opening.midpoint())},
                     {"width_m", rounded(door.opening.length(), 2)}});
  return doors;
}

}  // namespace

Json changes_json(const BuildingChanges& changes) {
  const auto length_m = [&](WallChange change) { return rounded(changes.length_m(change), 1); };
  const auto area_m2 = [&](FloorChange change) { return rounded(changes.floor.area_m2(change), 2); };
  return {{"walls_m",
           {{"kept", length_m(WallChange::kKept)},
            {"new", length_m(WallChange::kNew)},
            {"gone", length_m(WallChange::kGone)},
            {"moved", length_m(WallChange::kMoved)},
            {"not_compared", length_m(WallChange::kNotCompared)}}},
          {"floor_m2",
           {{"compared",
             rounded(changes.floor.area_m2(FloorChange::kSame) + changes.floor.area_m2(FloorChange::kWon) +
                         changes.floor.area_m2(FloorChange::kLost),
                     2)},
            {"won", area_m2(FloorChange::kWon)},
            {"lost", area_m2(FloorChange::kLost)},
            {"only_old", area_m2(FloorChange::kOnlyOld)},
            {"only_new", area_m2(FloorChange::kOnlyNew)}}},
          {"doors", changed_doors(changes)},
          {"changed_walls", changed_walls(changes)}};
}

std::string changes_text(const Json& figures) {
  const Json &walls = figures["walls_m"], &floor = figures["floor_m2"];
  std::string text = fmt::format(
      "walls: {} m in both, {} m new, {} m gone, {} m moved, {} m not compared\n"
      "floor: {} m2 in both, {} m2 of cells won, {} m2 lost; {} m2 in the old map only and {} m2 in the new "
      "one only: not compared\n",
      walls["kept"].get<double>(), walls["new"].get<double>(), walls["gone"].get<double>(),
      walls["moved"].get<double>(), walls["not_compared"].get<double>(), floor["compared"].get<double>(),
      floor["won"].get<double>(), floor["lost"].get<double>(), floor["only_old"].get<double>(),
      floor["only_new"].get<double>());
  for (const Json& door : figures["doors"])
    text += fmt::format("  a door of {:.2f} m at {:.2f}, {:.2f} is now {}\n", door["width_m"].get<double>(),
                        door["at_m"][0].get<double>(), door["at_m"][1].get<double>(),
                        door["now"].get<std::string>());
  for (const Json& wall : figures["changed_walls"]) {
    text += fmt::format("  {}: {:.2f}, {:.2f} to {:.2f}, {:.2f}", wall["change"].get<std::string>(),
                        wall["start_m"][0].get<double>(), wall["start_m"][1].get<double>(),
                        wall["end_m"][0].get<double>(), wall["end_m"][1].get<double>());
    text += wall.contains("moved_m") ? fmt::format(", by {:.2f} m\n", wall["moved_m"].get<double>()) : "\n";
  }
  return text;
}

std::string changes_caption(const Json& figures) {
  const Json& walls = figures["walls_m"];
  return fmt::format("walls: {} m in both, {} m new, {} m gone, {} m moved; doors shut or opened: {}",
                     walls["kept"].get<double>(), walls["new"].get<double>(), walls["gone"].get<double>(),
                     walls["moved"].get<double>(), figures["doors"].size());
}

}  // namespace aisle
