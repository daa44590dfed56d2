#include "aisle/commands/diff.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/merging/building_changes.hpp"
#include "aisle/report/changes_picture.hpp"
#include "merging/comparable_map.hpp"

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

Json figures_of(const MapAlignment& alignment, const BuildingChanges& changes) {
  const auto length_m = [&](WallChange change) { return rounded(changes.length_m(change), 1); };
  const auto area_m2 = [&](FloorChange change) { return rounded(changes.floor.area_m2(change), 2); };
  return {{"alignment", alignment_json(alignment)},
          {"walls_m",
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

std::string alignment_text(const MapAlignment& alignment) {
  const MapPlacement& best = alignment.best();
  const Pose2& T = best.T_fixed_moved;
  return fmt::format(
      "the new map lies at {:.2f}, {:.2f} m, {:.1f} degrees in the old one, known to {:.1f} cm and {:.2f} "
      "degrees: {}\n",
      T.x, T.y, to_degrees(T.theta), 100 * best.sigma_m(), to_degrees(best.sigma_rad()),
      reason_of(alignment));
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

Outcome refusal(const MapAlignment& alignment) {
  Outcome outcome{.verb = "diff", .ok = false};
  outcome.figures = {{"alignment", alignment_json(alignment)}};
  outcome.text = fmt::format("not compared: {}\n", reason_of(alignment));
  return outcome;
}

}  // namespace

Outcome diff_parameters() {
  MapAlignmentParams params;
  return parameter_listing("diff", fields_of(params));
}

Result<Outcome> run_diff(const DiffOptions& options, Console& console) {
  MapAlignmentParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  const auto old_map = read_comparable_map(options.old_building, console);
  if (!old_map) return old_map.problems();
  const auto new_map = read_comparable_map(options.new_building, console);
  if (!new_map) return new_map.problems();
  const auto directory =
      OutputDirectory::open_if_named(options.out, options.force, {"changes.svg", "changes.png"});
  if (!directory) return directory.problems();

  console.progress.report("laying the maps onto each other", 0, 1);
  const MapAlignment alignment = align_maps(MapPattern(*old_map), MapPattern(*new_map), params);
  if (!alignment.is_found()) return refusal(alignment);
  const BuildingChanges changes = changes_between(*old_map, *new_map, alignment.best().T_fixed_moved);

  Outcome outcome{.verb = "diff"};
  outcome.figures = figures_of(alignment, changes);
  outcome.text = alignment_text(alignment) + changes_text(outcome.figures);
  if (!*directory) return outcome;
  const Json& walls = outcome.figures["walls_m"];
  const ChangesPicture picture{
      changes, fmt::format("{}: what has changed", old_map->name),
      fmt::format("walls: {} m in both, {} m new, {} m gone, {} m moved; doors shut or opened: {}",
                  walls["kept"].get<double>(), walls["new"].get<double>(), walls["gone"].get<double>(),
                  walls["moved"].get<double>(), changes.doors.size())};
  auto written = (*directory)
                     ->write({{"picture_svg", "changes.svg", svg(picture)},
                              {"picture_png", "changes.png", png(picture)}});
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  outcome.text += fmt::format("see {}\n", outcome.files["picture_png"]);
  return outcome;
}

}  // namespace aisle
