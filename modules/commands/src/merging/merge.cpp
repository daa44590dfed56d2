#include "aisle/commands/merge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/merging/building_merging.hpp"
#include "aisle/report/building_picture.hpp"
#include "merging/comparable_map.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPartsMax = 50;

/// What tells a part from the others: the file's name, or its folder's, where all are called alike.
std::string part_name(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const std::string folder = std::filesystem::absolute(file).parent_path().filename().string();
  return stem == "building" || stem == "map" ? folder : stem;
}

Result<std::vector<MapPart>> read_parts(const std::vector<std::filesystem::path>& files, Console& console) {
  std::vector<MapPart> parts;
  Problems problems;
  for (const std::filesystem::path& file : files) {
    auto building = read_comparable_map(file, console);
    if (!building) {
      problems.insert(problems.end(), building.problems().begin(), building.problems().end());
      continue;
    }
    const std::string name = part_name(file);
    const bool is_taken =
        std::any_of(parts.begin(), parts.end(), [&](const MapPart& part) { return part.name == name; });
    parts.push_back({is_taken ? fmt::format("{} {}", name, parts.size() + 1) : name, std::move(*building)});
  }
  if (!problems.empty()) return problems;
  return parts;
}

Json figures_of(const std::vector<MapPart>& parts, const MergedBuilding& merged) {
  Json figures = {{"parts", Json::array()}, {"links", Json::array()}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    figures["parts"].push_back({{"name", parts[i].name}, {"walls", parts[i].building.walls.walls.size()}});
    if (!merged.T_map_part.empty()) figures["parts"].back().update(placement_json(merged.T_map_part[i]));
  }
  for (const PartLink& link : merged.links) {
    figures["links"].push_back({{"parts", {parts[link.first].name, parts[link.second].name}}});
    figures["links"].back().update(alignment_json(link.alignment));
  }
  figures["why_refused"] = merged.why_refused;
  figures["notes"] = merged.notes;
  if (!merged.building) return figures;
  const Building& building = *merged.building;
  figures["walls"] = building.walls.walls.size();
  figures["free_m2"] = rounded(building.floor->free_m2(), 1);
  figures["corridors_m"] = rounded(building.corridors.length_m(), 1);
  figures["places"] = building.places.size();
  figures["routes"] = building.routes.size();
  figures["landmarks"] = building.landmarks.size();
  return figures;
}

std::string indented(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += fmt::format("  {}\n", line);
  return text;
}

std::string text_of(const std::vector<MapPart>& parts, const MergedBuilding& merged) {
  if (!merged.building) return "not merged:\n" + indented(merged.why_refused);
  const Building& building = *merged.building;
  std::string text = fmt::format(
      "{} maps are one: {} walls, {:.0f} m2 of free floor, {:.0f} m of corridors, {} places, {} routes, {} "
      "landmarks\n",
      parts.size(), building.walls.walls.size(), building.floor->free_m2(), building.corridors.length_m(),
      building.places.size(), building.routes.size(), building.landmarks.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Pose2& T = merged.T_map_part[i];
    text += fmt::format("  {} lies at {:.2f}, {:.2f} m, {:.1f} degrees\n", parts[i].name, T.x, T.y,
                        to_degrees(T.theta));
  }
  for (const PartLink& link : merged.links)
    text += fmt::format("  {} and {}: {}\n", parts[link.first].name, parts[link.second].name,
                        reason_of(link.alignment));
  return text + indented(merged.notes);
}

}  // namespace

Outcome merge_parameters() {
  MergeParams params;
  return parameter_listing("merge", fields_of(params));
}

Result<Outcome> run_merge(const MergeOptions& options, Console& console) {
  MergeParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  if (options.buildings.size() > kPartsMax)
    return Problem{{"BUILDING"},
                   fmt::format("{} maps are more than {}: merge some of them first", options.buildings.size(),
                               kPartsMax)};
  const auto parts = read_parts(options.buildings, console);
  if (!parts) return parts.problems();
  const auto directory = OutputDirectory::open_if_named(options.out, options.force,
                                                        {"building.json", "building.svg", "building.png"});
  if (!directory) return directory.problems();

  const MergedBuilding merged = merge_buildings(*parts, params, console.progress);
  Outcome outcome{.verb = "merge", .ok = merged.building.has_value()};
  outcome.figures = figures_of(*parts, merged);
  outcome.text = text_of(*parts, merged);
  if (!merged.building || !*directory) return outcome;
  const BuildingPicture picture{.building = *merged.building,
                                .title = merged.building->name,
                                .caption = fmt::format("merged of {} maps; {:.1f} m2 of free floor",
                                                       parts->size(), merged.building->floor->free_m2())};
  auto written = (*directory)
                     ->write({{"building", "building.json", building_json(*merged.building)},
                              {"picture_svg", "building.svg", svg(picture)},
                              {"picture_png", "building.png", png(picture)}});
  if (!written) return written.problems();
  outcome.files = std::move(*written);
  outcome.text += fmt::format("see {}\n", outcome.files["picture_png"]);
  return outcome;
}

}  // namespace aisle
