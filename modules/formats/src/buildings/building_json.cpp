#include "aisle/formats/buildings/building_json.hpp"

#include <fmt/format.h>

#include "aisle/formats/json_document.hpp"
#include "aisle/formats/whole_file.hpp"
#include "buildings/building_parts.hpp"
#include "file_limits.hpp"

namespace aisle {
namespace {

constexpr std::string_view kBuildingFormat = "aisle.building";
constexpr int kBuildingVersion = 3;
constexpr int kOldestVersion = 1;  // 1: landmarks in a list; 2: corridors with "way_m"

/// A fact about the file that is checked before its parts are read.
JsonPart header_part(std::string_view key, std::string text) {
  return needed(JsonPart{key, [text = std::move(text)] { return text; }, [](const JsonValue&) {}});
}

JsonFields building_fields(Building& building) {
  return {header_part("format", fmt::format("\"{}\"", kBuildingFormat)),
          header_part("version", std::to_string(kBuildingVersion)),
          field::text("name", building.name),
          field::flag("has_dominant_direction", building.has_dominant_direction),
          walls_part("walls", building.walls),
          camera_part("camera", building.camera),
          landmarks_part("landmarks", building.landmarks),
          unless_empty(wall_directions_part("wall_directions", building.wall_directions)),
          unless_empty(routes_part("routes", building.routes)),
          corridors_part("corridors", building.corridors),
          unless_empty(places_part("places", building.places)),
          unless_empty(barriers_part("barriers", building.barriers)),
          unless_empty(zones_part("zones", building.zones)),
          floor_part("floor", building.floor)};
}

}  // namespace

std::string building_json(const Building& building) {
  Building copy = building;  // the fields of an object serve reading too
  return "{\n" + members_json(building_fields(copy), ",\n") + "\n}\n";
}

Result<Building> parse_building(std::string_view text, const std::string& name) {
  const Result<nlohmann::json> document = parse_json(text, name);
  if (!document) return document.problems();
  ProblemList problems(name);
  const JsonValue root(*document, "", problems);
  if (!document->is_object()) return Problem{{name}, "is not a JSON object"};
  const auto format = root.find("format");
  if (!format || !format->is(kBuildingFormat)) {
    return Problem{{name, 0, "format"},
                   fmt::format("is not \"{}\": this is not a building file", kBuildingFormat)};
  }
  int version = kBuildingVersion;  // without one, its absence is reported with the other problems
  if (const auto value = root.find("version")) value->read_count(version, field::kAnyCount);
  if (problems.empty() && (version < kOldestVersion || version > kBuildingVersion)) {
    return Problem{{name, 0, "version"},
                   fmt::format("{} is unknown; this program reads versions {} to {}", version, kOldestVersion,
                               kBuildingVersion)};
  }
  Building building;
  read_object(root, building_fields(building));
  if (!building.landmarks.empty()) root.require("camera");
  if (!problems.empty()) return problems.take();
  return building;
}

Result<Building> read_building(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kJsonBytesMax);
  if (!text) return text.problems();
  return parse_building(*text, path.string());
}

}  // namespace aisle
