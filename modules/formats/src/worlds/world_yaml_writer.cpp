#include "aisle/formats/worlds/world_yaml.hpp"
#include "object_yaml.hpp"
#include "worlds/world_fields.hpp"

namespace aisle {
namespace {

/// Consecutive wall faces with equal properties become one line.
std::vector<WallLine> wall_lines(const World& world) {
  std::vector<WallLine> lines;
  for (const WallFace& wall : world.walls) {
    const double height_m = wall.height_m == world.ceiling_m ? WallLine{}.height_m : wall.height_m;
    const bool goes_on = !lines.empty() && lines.back().line.back() == wall.floor_edge.start &&
                         lines.back().height_m == height_m && lines.back().brightness == wall.brightness &&
                         lines.back().returns == wall.returns;
    if (!goes_on) lines.push_back({{wall.floor_edge.start}, height_m, wall.brightness, wall.returns});
    lines.back().line.push_back(wall.floor_edge.end);
  }
  return lines;
}

std::string walls_text(const World& world) {
  if (world.walls.empty()) return "walls: []\n";
  std::string text = "walls:\n";
  for (const WallLine& wall : wall_lines(world)) {
    const bool is_line_alone = yaml_entries(wall, "").size() == 1;
    text += fmt::format("  - {}\n", is_line_alone ? yaml_points(wall.line, "     ") : yaml_map(wall));
  }
  return text;
}

}  // namespace

std::string world_yaml(const World& world) {
  std::string text = "format: aisle.world\nversion: 1\n";
  for (const std::string& entry : yaml_entries(world, "  ")) text += entry + "\n";
  if (const auto floor = yaml_entries(world.floor, ""); !floor.empty()) {
    text += fmt::format("floor: {}\n", yaml_map(world.floor));
  }
  if (world.start) text += fmt::format("start: {}\n", yaml_map(*world.start));
  text += walls_text(world);
  for_each_list(world,
                [&](const char* key, const auto& objects, std::size_t) { text += yaml_list(key, objects); });
  return text;
}

}  // namespace aisle
