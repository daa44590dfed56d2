#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "images/drawing.hpp"
#include "images/dxf_reader.hpp"

namespace aisle {
namespace {

Problems skipped_parts(const DxfDrawing& dxf, const std::string& name) {
  Problems warnings;
  std::vector<std::string> kinds;
  for (const auto& [kind, count] : dxf.skipped) kinds.push_back(fmt::format("{} {}", count, kind));
  if (!kinds.empty()) warnings.push_back({{name}, fmt::format("is read without {}", fmt::join(kinds, ", "))});
  if (dxf.door_arcs > 0)
    warnings.push_back(
        {{name}, fmt::format("is read without {} quarter circles: arcs of doors", dxf.door_arcs)});
  return warnings;
}

}  // namespace

Result<Drawing> read_dxf(std::string_view bytes, const std::string& name) {
  auto read = parse_dxf(bytes, name);
  if (!read) return read.problems();
  const auto dxf = std::make_shared<const DxfDrawing>(std::move(*read));
  if (dxf->lines.empty()) return Problem{{name}, "has no line, polyline, arc or circle"};
  Vec2 min = dxf->lines.front().start, max = min;
  for (const DxfLine& line : dxf->lines) {
    min = min.cwiseMin(line.start).cwiseMin(line.end);
    max = max.cwiseMax(line.start).cwiseMax(line.end);
  }
  if (!min.allFinite() || !max.allFinite()) return Problem{{name}, "has coordinates that are too large"};
  Drawing drawing;
  // Lines are centred on the walls' faces: half a percent of rim keeps the outer ones inside.
  const Vec2 rim = Vec2::Constant(0.005 * (max - min).maxCoeff());
  const Vec2 corner(min.x() - rim.x(), max.y() + rim.y());
  drawing.width = (max - min + 2 * rim).x();
  drawing.height = (max - min + 2 * rim).y();
  drawing.unit_m = dxf->unit_m;
  drawing.warnings = skipped_parts(*dxf, name);
  drawing.paint = [dxf, corner](cairo_t* canvas, double cell) {
    cairo_set_line_width(canvas, cell);
    cairo_set_line_cap(canvas, CAIRO_LINE_CAP_SQUARE);
    for (const DxfLine& line : dxf->lines) {
      cairo_move_to(canvas, line.start.x() - corner.x(), corner.y() - line.start.y());
      cairo_line_to(canvas, line.end.x() - corner.x(), corner.y() - line.end.y());
    }
    cairo_stroke(canvas);
    return true;
  };
  return drawing;
}

}  // namespace aisle
