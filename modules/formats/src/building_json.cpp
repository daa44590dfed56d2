#include "aisle/formats/building_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "aisle/formats/whole_file.hpp"
#include "json_value.hpp"

namespace aisle {
namespace {

constexpr std::string_view kBuildingFormat = "aisle.building";
constexpr int kBuildingVersion = 1;
constexpr double kSigmaLimit_m = 1e3;

/// To the millimetre, without trailing zeros and without "-0".
std::string millimetres(double value_m) {
  std::string text = fmt::format("{:.3f}", value_m);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string point_json(const Vec2& p) {
  return "[" + millimetres(p.x()) + ", " + millimetres(p.y()) + "]";
}

const char* end_text(WallEnd end) {
  return end == WallEnd::kSeen ? "seen" : "unknown";
}

std::string wall_text(const Wall& wall) {
  return fmt::format(
      R"({{"start_m": {}, "end_m": {}, "orthogonal": {}, "ends": ["{}", "{}"], "sightings": {}, "sigma_m": {:.4f}}})",
      point_json(wall.segment.start), point_json(wall.segment.end), wall.is_orthogonal, end_text(wall.start),
      end_text(wall.end), wall.sightings, wall.sigma_m);
}

void read_wall_end(const JsonValue& value, WallEnd& target) {
  if (value.is("seen")) {
    target = WallEnd::kSeen;
  } else if (value.is("unknown")) {
    target = WallEnd::kUnknown;
  } else {
    value.wrong(R"(is neither "seen" nor "unknown")");
  }
}

Wall read_wall(const JsonValue& value) {
  Wall wall;
  if (!value.is_object_of({"start_m", "end_m", "orthogonal", "ends", "sightings", "sigma_m"})) return wall;
  if (const auto start = value.require("start_m")) start->read_point(wall.segment.start);
  if (const auto end = value.require("end_m")) end->read_point(wall.segment.end);
  if (const auto orthogonal = value.find("orthogonal")) orthogonal->read(wall.is_orthogonal);
  if (const auto ends = value.find("ends"); ends && ends->is_list_of(2)) {
    read_wall_end(ends->element(0), wall.start);
    read_wall_end(ends->element(1), wall.end);
  }
  if (const auto sightings = value.find("sightings")) sightings->read_count(wall.sightings);
  if (const auto sigma = value.find("sigma_m")) sigma->read_number(wall.sigma_m, 0, kSigmaLimit_m);
  return wall;
}

Building read_version_1(const JsonValue& root) {
  Building building;
  root.is_object_of({"format", "version", "name", "has_dominant_direction", "walls"});
  if (const auto name = root.find("name")) name->read(building.name);
  if (const auto dominant = root.find("has_dominant_direction"))
    dominant->read(building.has_dominant_direction);
  if (const auto walls = root.find("walls"); walls && walls->is_list()) {
    for (std::size_t i = 0; i < walls->size(); ++i)
      building.walls.walls.push_back(read_wall(walls->element(i)));
  }
  return building;
}

}  // namespace

std::string building_json(const Building& building) {
  const nlohmann::json name = building.name;
  std::string text = fmt::format(
      "{{\n\"format\": \"{}\",\n\"version\": {},\n\"name\": {},\n\"has_dominant_direction\": {},\n\"walls\": "
      "[",
      kBuildingFormat, kBuildingVersion, name.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
      building.has_dominant_direction);
  const char* before = "\n";
  for (const Wall& wall : building.walls.walls) {
    text += before + wall_text(wall);
    before = ",\n";
  }
  return text + "\n]\n}\n";
}

Result<Building> parse_building(std::string_view text, const std::string& name) {
  const Result<nlohmann::json> document = parse_json(text, name);
  if (!document) return document.problems();
  ProblemList problems(name);
  const JsonValue root(*document, "", problems);
  if (!document->is_object()) return Problem{{name}, "is no JSON object"};
  const auto format = root.find("format");
  if (!format || !format->is(kBuildingFormat)) {
    return Problem{{name, 0, "format"}, fmt::format("is not \"{}\": this is no building", kBuildingFormat)};
  }
  int version = 0;
  if (const auto value = root.require("version")) value->read_count(version);
  if (problems.empty() && version != kBuildingVersion) {
    return Problem{
        {name, 0, "version"},
        fmt::format("{} is unknown here; this program reads version {}", version, kBuildingVersion)};
  }
  Building building = read_version_1(root);
  if (!problems.empty()) return problems.take();
  return building;
}

Result<Building> read_building(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path);
  if (!text) return text.problems();
  return parse_building(*text, path.string());
}

}  // namespace aisle
