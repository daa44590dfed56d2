#include <algorithm>
#include <optional>

#include "aisle/vision/floor/base_lines.hpp"
#include "lines/line_contrast.hpp"

namespace aisle {

namespace {

// Shares of the image's height.
constexpr double kOnFloor = 0.015;    // a line that begins this far beneath the base line lies on the floor
constexpr double kBeneath = 0.03;     // a line that reaches this far beneath it may be its own reflection
constexpr double kBeyondEnd = 0.04;   // beneath the far ends of both base lines there is floor between them
constexpr double kBorder = 0.01;      // a line cut by the image's border shows no lower end
constexpr double kFaded = 0.6;        // share of its contrast that a line loses at the floor to end there
constexpr double kBoardDepth = 0.25;  // what ends lower stands on the floor: share of the camera's height

/// Height of a base line, continued towards the viewer; nullopt beyond its far end.
std::optional<double> v_on(const BaseLine& line, double u_px) {
  const double towards = line.back().x() > line.front().x() ? 1 : -1;
  if (towards * (u_px - line.front().x()) < 0) return std::nullopt;
  std::size_t i = 1;
  while (i + 1 < line.size() && towards * (u_px - line[i].x()) > 0) ++i;
  const Vec2 along = line[i] - line[i - 1];
  return line[i - 1].y() + along.y() / along.x() * (u_px - line[i - 1].x());
}

std::optional<double> v_on_any(const BaseLines& lines, double u_px) {
  for (const auto& line : {lines.right, lines.left}) {
    if (!line) continue;
    if (const auto v_px = v_on(*line, u_px)) return v_px;
  }
  return std::nullopt;
}

/// The row where the floor begins in a column, if known.
std::optional<double> floor_from(const BaseLines& lines, double u_px, int height_px) {
  if (const auto v_px = v_on_any(lines, u_px)) return v_px;
  if (!lines.left || !lines.right) return std::nullopt;
  return std::max(lines.left->front().y(), lines.right->front().y()) + kBeyondEnd * height_px;
}

/// The line without its reflection in the floor; nullopt if nothing remains.
std::optional<VerticalLine> without_reflection(const Image& grey, const BaseLines& base_lines,
                                               const BaseLineParams& params, VerticalLine line) {
  const double height_px = grey.height_px;
  const auto floor_px = floor_from(base_lines, line.bottom_px.x(), grey.height_px);
  if (!floor_px) return line;
  if (line.top_px.y() > *floor_px + kOnFloor * height_px) return std::nullopt;
  if (line.bottom_px.y() < *floor_px + kBeneath * height_px) return line;
  if (line.top_px.y() > *floor_px - kBeneath * height_px) return line;
  const double above = contrast_between(grey, line, line.top_px.y(), *floor_px - 0.01 * height_px);
  const double beneath = contrast_between(grey, line, *floor_px + 0.02 * height_px, line.bottom_px.y());
  if (beneath >= kFaded * above) return line;
  line.bottom_px = {u_at(line, *floor_px), *floor_px};
  if (line.bottom_px.y() - line.top_px.y() < params.standing_share_min * height_px) return std::nullopt;
  return line;
}

/// The line with its lower end moved onto the base line, if it ends on that or on the skirting board above
/// it.
std::optional<VerticalLine> with_floor_point(const BaseLines& base_lines, const BaseLineParams& params,
                                             VerticalLine line, int height_px) {
  if (line.bottom_px.y() > (1 - kBorder) * height_px) return std::nullopt;
  const auto v_px = v_on_any(base_lines, line.bottom_px.x());
  if (!v_px) return std::nullopt;
  const double tolerance_px = params.floor_point_share * height_px;
  const double depth_px = base_lines.vanishing_point_px ? *v_px - base_lines.vanishing_point_px->y() : 0;
  const double above_px = *v_px - line.bottom_px.y();
  if (above_px < -tolerance_px || above_px > std::max(tolerance_px, kBoardDepth * depth_px))
    return std::nullopt;
  line.bottom_px = {u_at(line, *v_px), *v_px};
  line.has_floor_point = true;
  return line;
}

}  // namespace

void stand_on_floor(const Image& grey, const BaseLines& base_lines, const BaseLineParams& params,
                    std::vector<VerticalLine>& verticals) {
  std::size_t kept = 0;
  for (const VerticalLine& line : verticals) {
    auto standing = without_reflection(grey, base_lines, params, line);
    if (!standing) continue;
    verticals[kept++] = with_floor_point(base_lines, params, *standing, grey.height_px).value_or(*standing);
  }
  verticals.resize(kept);
}

}  // namespace aisle
