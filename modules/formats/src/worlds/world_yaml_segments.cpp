#include <fmt/format.h>

#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {}  // namespace

Result<World> read_wall_segments(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kWorldBytesMax);
  if (!text) return text.problems();
  return parse_wall_segments(*text, path.string());
}

Result<World> parse_wall_segments(std::string_view text, const std::string& name) {
  World world{.name = std::filesystem::path(name).stem().string()};
  ProblemList problems(name);
  for (long line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    FieldReader fields(line);
    if (const std::string_view first = FieldReader(line).word(); first.empty() || first[0] == '#') continue;
    const double x1 = fields.number("x1", kCoordinateMax_m), y1 = fields.number("y1", kCoordinateMax_m);
    const double x2 = fields.number("x2", kCoordinateMax_m), y2 = fields.number("y2", kCoordinateMax_m);
    if (!fields.ok()) {
      problems.add(line_number, fields.failure());
    } else if (Vec2(x1, y1) != Vec2(x2, y2)) {
      world.walls.push_back({.floor_edge = {{x1, y1}, {x2, y2}}});
    }
  }
  if (!problems.empty()) return problems.take();
  if (world.walls.empty()) return Problem{{name}, "has no wall segments 'x1 y1 x2 y2 kind'"};
  if (world.walls.size() > kWorldWallsMax) {
    return Problem{
        {name}, fmt::format("has {} wall segments; at most {} are read", world.walls.size(), kWorldWallsMax)};
  }
  return world;
}

}  // namespace aisle
