#include "buildings/wall_json.hpp"

#include <fmt/format.h>

#include "buildings/json_text.hpp"

namespace aisle {
namespace {

constexpr double kSigmaMax_m = 1e3;

const char* end_text(WallEnd end) {
  return end == WallEnd::kSeen ? "seen" : "unknown";
}

std::string wall_json(const Wall& wall) {
  return fmt::format(
      R"({{"start_m": {}, "end_m": {}, "orthogonal": {}, "ends": ["{}", "{}"], "sightings": {}, "sigma_m": {:.4f}}})",
      point_json(wall.segment.start, kMillimetreDecimals), point_json(wall.segment.end, kMillimetreDecimals),
      wall.is_orthogonal, end_text(wall.start), end_text(wall.end), wall.sightings, wall.sigma_m);
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
  if (const auto sigma = value.find("sigma_m")) sigma->read_number(wall.sigma_m, 0, kSigmaMax_m);
  return wall;
}

}  // namespace

std::string walls_json(const WallMap& map) {
  std::vector<std::string> walls;
  for (const Wall& wall : map.walls) walls.push_back(wall_json(wall));
  return list_json(walls);
}

WallMap read_walls(const JsonValue& value) {
  WallMap map;
  if (!value.is_list()) return map;
  for (std::size_t i = 0; i < value.size(); ++i) map.walls.push_back(read_wall(value.element(i)));
  return map;
}

}  // namespace aisle
