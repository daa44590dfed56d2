#include "aisle/formats/buildings/building_json.hpp"

#include <fmt/format.h>

#include "aisle/formats/whole_file.hpp"
#include "buildings/barrier_json.hpp"
#include "buildings/camera_json.hpp"
#include "buildings/corridor_json.hpp"
#include "buildings/floor_json.hpp"
#include "buildings/json_text.hpp"
#include "buildings/json_value.hpp"
#include "buildings/landmark_json.hpp"
#include "buildings/route_json.hpp"
#include "buildings/wall_direction_json.hpp"
#include "buildings/wall_json.hpp"

namespace aisle {
namespace {

constexpr std::string_view kBuildingFormat = "aisle.building";
constexpr int kBuildingVersion = 3;
constexpr int kOldestVersion = 1;  // 1: landmarks in a list; 2: corridors with "way_m"

Building read_parts(const JsonValue& root) {
  Building building;
  root.is_object_of({"format", "version", "name", "has_dominant_direction", "walls", "camera", "landmarks",
                     "wall_directions", "routes", "corridors", "places", "barriers", "floor"});
  if (const auto name = root.find("name")) name->read(building.name);
  if (const auto dominant = root.find("has_dominant_direction"))
    dominant->read(building.has_dominant_direction);
  if (const auto walls = root.find("walls")) building.walls = read_walls(*walls);
  if (const auto camera = root.find("camera")) building.camera = read_camera(*camera);
  if (const auto landmarks = root.find("landmarks")) building.landmarks = read_landmarks(*landmarks);
  if (const auto directions = root.find("wall_directions"))
    building.wall_directions = read_wall_directions(*directions);
  if (const auto routes = root.find("routes")) building.routes = read_routes(*routes);
  if (const auto corridors = root.find("corridors")) building.corridors = read_corridors(*corridors);
  if (const auto places = root.find("places")) building.places = read_places(*places);
  if (const auto barriers = root.find("barriers")) building.barriers = read_barriers(*barriers);
  if (const auto floor = root.find("floor")) building.floor = read_floor(*floor);
  if (!building.landmarks.empty()) root.require("camera");
  return building;
}

}  // namespace

std::string building_json(const Building& building) {
  std::string text = fmt::format(
      "{{\n\"format\": \"{}\",\n\"version\": {},\n\"name\": {},\n\"has_dominant_direction\": {}",
      kBuildingFormat, kBuildingVersion, quoted_json(building.name), building.has_dominant_direction);
  text += ",\n\"walls\": " + walls_json(building.walls);
  if (building.camera) text += ",\n\"camera\": " + camera_json(*building.camera);
  if (!building.landmarks.empty()) text += ",\n\"landmarks\": " + landmarks_json(building.landmarks);
  if (!building.wall_directions.empty())
    text += ",\n\"wall_directions\": " + wall_directions_json(building.wall_directions);
  if (!building.routes.empty()) text += ",\n\"routes\": " + routes_json(building.routes);
  if (!building.corridors.nodes.empty()) text += ",\n\"corridors\": " + corridors_json(building.corridors);
  if (!building.places.empty()) text += ",\n\"places\": " + places_json(building.places);
  if (!building.barriers.empty()) text += ",\n\"barriers\": " + barriers_json(building.barriers);
  if (building.floor) text += ",\n\"floor\": " + floor_json(*building.floor);
  return text + "\n}\n";
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
  int version = 0;
  if (const auto value = root.require("version")) value->read_count(version);
  if (problems.empty() && (version < kOldestVersion || version > kBuildingVersion)) {
    return Problem{{name, 0, "version"},
                   fmt::format("{} is unknown; this program reads versions {} to {}", version, kOldestVersion,
                               kBuildingVersion)};
  }
  Building building = read_parts(root);
  if (!problems.empty()) return problems.take();
  return building;
}

Result<Building> read_building(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path);
  if (!text) return text.problems();
  return parse_building(*text, path.string());
}

}  // namespace aisle
