#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "aisle/formats/world_yaml.hpp"

namespace aisle {
namespace {

double to_millimetre(double value_m) {
  return std::round(value_m * 1000) / 1000 + 0.0;  // + 0.0: never "-0"
}

std::string polyline_text(const std::vector<Vec2>& points, std::string_view indent) {
  constexpr std::size_t kPointsInALine = 6;
  std::string text = "[";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += i % kPointsInALine == 0 ? fmt::format(",\n{}", indent) : ", ";
    text += fmt::format("[{}, {}]", to_millimetre(points[i].x()), to_millimetre(points[i].y()));
  }
  return text + "]";
}

std::vector<std::vector<Vec2>> polylines(const std::vector<WallFace>& walls) {
  std::vector<std::vector<Vec2>> joined;
  for (const WallFace& wall : walls) {
    if (joined.empty() || joined.back().back() != wall.foot.start) joined.push_back({wall.foot.start});
    joined.back().push_back(wall.foot.end);
  }
  return joined;
}

}  // namespace

std::string world_yaml(const World& world) {
  YAML::Emitter name;
  name << YAML::DoubleQuoted << world.name;
  std::string text = fmt::format("format: aisle.world\nversion: 1\nname: {}\nwalls:{}\n", name.c_str(),
                                 world.walls.empty() ? " []" : "");
  for (const std::vector<Vec2>& line : polylines(world.walls)) {
    text += fmt::format("  - {}\n", polyline_text(line, "     "));
  }
  return text + fmt::format("tour: {}\n", polyline_text(world.tour, "  "));
}

}  // namespace aisle
