#include "buildings/wall_direction_json.hpp"

#include <fmt/format.h>

#include "aisle/core/angle.hpp"
#include "buildings/json_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kDirectionsMax = 100'000;
constexpr int kAngleDecimals = 2;  // of degrees

WallDirection read_direction(const JsonValue& value) {
  WallDirection walls;
  if (!value.is_object_of({"at_m", "direction_deg", "sigma_deg"})) return walls;
  if (const auto at = value.require("at_m")) at->read_point(walls.p_map);
  double direction_deg = 0, sigma_deg = 1;
  if (const auto direction = value.require("direction_deg")) direction->read_number(direction_deg, -45, 45);
  if (const auto sigma = value.require("sigma_deg")) sigma->read_number(sigma_deg, 0.01, 45);
  walls.direction_rad = direction_deg * kDegree;
  walls.sigma_rad = sigma_deg * kDegree;
  return walls;
}

}  // namespace

std::string wall_directions_json(const std::vector<WallDirection>& directions) {
  std::vector<std::string> texts;
  texts.reserve(directions.size());
  for (const WallDirection& walls : directions)
    texts.push_back(fmt::format(R"({{"at_m": {}, "direction_deg": {}, "sigma_deg": {}}})",
                                point_json(walls.p_map, kMillimetreDecimals),
                                decimals(to_degrees(walls.direction_rad), kAngleDecimals),
                                decimals(to_degrees(walls.sigma_rad), kAngleDecimals)));
  return list_json(texts);
}

std::vector<WallDirection> read_wall_directions(const JsonValue& value) {
  std::vector<WallDirection> directions;
  if (!value.is_list_up_to(kDirectionsMax)) return directions;
  directions.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) directions.push_back(read_direction(value.element(i)));
  return directions;
}

}  // namespace aisle
