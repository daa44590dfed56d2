#include "aisle/formats/buildings/floor_marks.hpp"

#include <fmt/format.h>

#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

constexpr std::size_t kMarksMax = 10'000;
constexpr double kPixelMax = 20'000;
constexpr double kPlaceMax_m = 100;

FloorMark read_mark(FieldReader& fields) {
  FloorMark mark;
  mark.pixel_px.x() = fields.number("u", kPixelMax);
  mark.pixel_px.y() = fields.number("v", kPixelMax);
  mark.p_vehicle.x() = fields.number("x", kPlaceMax_m);
  mark.p_vehicle.y() = fields.number("y", kPlaceMax_m);
  const std::string_view more = fields.word();
  if (fields.ok() && !more.empty() && more.front() != '#') fields.fail("more than the four numbers u v x y");
  return mark;
}

}  // namespace

Result<std::vector<FloorMark>> parse_floor_marks(std::string_view text, const std::string& name) {
  std::vector<FloorMark> marks;
  ProblemList problems(name);
  for (long line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    const std::string_view first = FieldReader(line).word();
    if (first.empty() || first.front() == '#') continue;
    FieldReader fields(line);
    marks.push_back(read_mark(fields));
    if (!fields.ok()) problems.add(line_number, fields.failure());
    if (marks.size() > kMarksMax) {
      return Problem{{name, line_number}, fmt::format("at most {} marks are read", kMarksMax)};
    }
  }
  if (!problems.empty()) return problems.take();
  if (marks.size() < kFloorMarksMin) {
    return Problem{{name},
                   fmt::format("has {} marks; at least {} are needed, one 'u v x y' a line", marks.size(),
                               kFloorMarksMin)};
  }
  return marks;
}

Result<std::vector<FloorMark>> read_floor_marks(const std::filesystem::path& path) {
  const Result<std::string> text = read_whole_file(path, kSettingsBytesMax);
  if (!text) return text.problems();
  return parse_floor_marks(*text, path.string());
}

}  // namespace aisle
