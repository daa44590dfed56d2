#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "aisle/formats/worlds/world_yaml.hpp"
#include "worlds/world_fields.hpp"
#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kPointsInALine = 6;

/// Rounded to a thousandth of the unit: millimetres, millidegrees.
std::string rounded(double value) {
  return fmt::format("{}", std::round(value * 1000) / 1000 + 0.0);  // + 0.0: never "-0"
}

std::string point_text(const std::vector<double>& coordinates) {
  std::vector<std::string> texts;
  texts.reserve(coordinates.size());
  for (const double value : coordinates) texts.push_back(rounded(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string polyline_text(const std::vector<Vec2>& points, std::string_view indent) {
  std::string text = "[";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += i % kPointsInALine == 0 ? fmt::format(",\n{}", indent) : ", ";
    text += point_text({points[i].x(), points[i].y()});
  }
  return text + "]";
}

std::string value_text(const ObjectField& field, std::string_view indent) {
  if (const auto* real = std::get_if<double*>(&field.target)) return rounded(**real / field.inner_unit);
  if (const auto* count = std::get_if<int*>(&field.target)) return fmt::format("{}", **count);
  if (const auto* whole = std::get_if<std::uint64_t*>(&field.target)) return fmt::format("{}", **whole);
  if (const auto* flag = std::get_if<bool*>(&field.target)) return **flag ? "true" : "false";
  if (const auto* point = std::get_if<PointTarget>(&field.target)) {
    std::vector<double> values;
    for (const double* value : point->coordinates) values.push_back(*value);
    return point_text(values);
  }
  if (const auto* points = std::get_if<std::vector<Vec2>*>(&field.target)) {
    return polyline_text(**points, indent);
  }
  if (const auto* text = std::get_if<std::string*>(&field.target)) return yaml_quoted(**text);
  const auto& word = std::get<WordTarget>(field.target);
  return std::string(word.words[word.index()]);
}

/// "key: value" of every field that is required or differs from its default.
template <class Object>
std::vector<std::string> entries(Object object, std::string_view indent) {
  Object plain;
  const ObjectFields fields = fields_of(object), plain_fields = fields_of(plain);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string value = value_text(fields[i], indent);
    if (!fields[i].is_needed && value == value_text(plain_fields[i], indent)) continue;
    texts.push_back(fmt::format("{}: {}", fields[i].key, value));
  }
  return texts;
}

template <class Object>
std::string map_text(const Object& object) {
  return fmt::format("{{{}}}", fmt::join(entries(object, "     "), ", "));
}

template <class Object>
std::string list_text(std::string_view key, const std::vector<Object>& objects) {
  if (objects.empty()) return {};
  std::string text = fmt::format("{}:\n", key);
  for (const Object& object : objects) text += fmt::format("  - {}\n", map_text(object));
  return text;
}

/// Consecutive wall faces with equal properties become one line.
std::vector<WallLine> wall_lines(const World& world) {
  std::vector<WallLine> lines;
  for (const WallFace& wall : world.walls) {
    const double height_m = wall.height_m == world.ceiling_m ? WallLine{}.height_m : wall.height_m;
    const bool goes_on = !lines.empty() && lines.back().line.back() == wall.floor_edge.start &&
                         lines.back().height_m == height_m && lines.back().brightness == wall.brightness;
    if (!goes_on) lines.push_back({{wall.floor_edge.start}, height_m, wall.brightness});
    lines.back().line.push_back(wall.floor_edge.end);
  }
  return lines;
}

std::string walls_text(const World& world) {
  if (world.walls.empty()) return "walls: []\n";
  std::string text = "walls:\n";
  for (const WallLine& wall : wall_lines(world)) {
    const bool is_line_alone = entries(wall, "").size() == 1;
    text += fmt::format("  - {}\n", is_line_alone ? polyline_text(wall.line, "     ") : map_text(wall));
  }
  return text;
}

}  // namespace

std::string world_yaml(const World& world) {
  std::string text = "format: aisle.world\nversion: 1\n";
  for (const std::string& entry : entries(world, "  ")) text += entry + "\n";
  if (const auto floor = entries(world.floor, ""); !floor.empty()) {
    text += fmt::format("floor: {}\n", map_text(world.floor));
  }
  if (world.start) text += fmt::format("start: {}\n", map_text(*world.start));
  text += walls_text(world);
  for_each_list(world,
                [&](const char* key, const auto& objects, std::size_t) { text += list_text(key, objects); });
  return text;
}

}  // namespace aisle
