#include "aisle/report/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "canvas.hpp"
#include "picture_scale.hpp"
#include "polyline.hpp"

namespace aisle {
namespace {

constexpr Color kPaper{1, 1, 1};
constexpr Color kInk{0.13, 0.17, 0.22};
constexpr Color kQuietInk{0.42, 0.47, 0.53};
constexpr Color kGrid{0.93, 0.945, 0.96};
constexpr Color kWallBody{0.86, 0.88, 0.905};
constexpr Color kWall{0.13, 0.17, 0.22};
constexpr Color kObliqueWall{0.78, 0.36, 0.08};
constexpr Color kPath{0.13, 0.47, 0.86};
constexpr Color kLoopClosure{0.10, 0.64, 0.36, 0.85};

constexpr Pen kPathPen{kPath, 1.75};
constexpr Pen kLoopPen{kLoopClosure, 2};
constexpr Pen kGridPen{kGrid, 1};
constexpr Font kTitleFont{30, kInk, true};
constexpr Font kCaptionFont{18, kQuietInk};
constexpr Font kLabelFont{17, kInk};

constexpr double kWallBody_m = 0.12;  ///< how much of a wall is shown behind its face
constexpr double kPathTolerance_px = 0.3;

class MapDrawing {
 public:
  MapDrawing(const MapPicture& picture, const PictureScale& scale) : picture_(picture), scale_(scale) {}

  void draw_on(Canvas& canvas) const;

 private:
  void draw_grid(Canvas& canvas) const;
  void draw_wall_bodies(Canvas& canvas) const;
  void draw_walls(Canvas& canvas, bool is_orthogonal) const;
  void draw_path(Canvas& canvas) const;
  void draw_loop_closures(Canvas& canvas) const;
  void draw_path_ends(Canvas& canvas) const;
  void draw_header(Canvas& canvas) const;
  void draw_scale_bar(Canvas& canvas) const;
  void draw_legend(Canvas& canvas) const;

  Pen wall_pen(const Wall& wall) const;
  double footer_line() const { return scale_.height_px - 36; }
  bool has_wall(bool is_orthogonal) const;

  const MapPicture& picture_;
  const PictureScale& scale_;
};

void MapDrawing::draw_on(Canvas& canvas) const {
  canvas.fill(kPaper);
  if (picture_.has_grid) draw_grid(canvas);
  draw_wall_bodies(canvas);
  draw_path(canvas);
  draw_loop_closures(canvas);
  draw_walls(canvas, false);
  draw_walls(canvas, true);
  draw_path_ends(canvas);
  draw_header(canvas);
  draw_scale_bar(canvas);
  draw_legend(canvas);
}

void MapDrawing::draw_grid(Canvas& canvas) const {
  const double step_m = round_length(75 / scale_.px_per_m);
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (int axis = 0; axis < 2; ++axis) {
    const auto first = static_cast<int>(std::ceil(scale_.low[axis] / step_m));
    const auto last = static_cast<int>(std::floor(scale_.high[axis] / step_m));
    for (int line = first; line <= last; ++line) {
      Vec2 start = scale_.low, end = scale_.high;
      start[axis] = end[axis] = line * step_m;
      lines.emplace_back(scale_.to_paper(start), scale_.to_paper(end));
    }
  }
  canvas.lines(lines, kGridPen);
}

/// A wall is known by its face; a strip behind it makes faces that belong together one solid wall.
void MapDrawing::draw_wall_bodies(Canvas& canvas) const {
  std::vector<std::array<Vec2, 4>> bodies;
  for (const Wall& wall : picture_.walls.walls) {
    const Segment2& face = wall.segment;
    const Vec2 behind = -kWallBody_m * left_normal(unit(face.heading()));
    bodies.push_back({scale_.to_paper(face.start), scale_.to_paper(face.end),
                      scale_.to_paper(face.end + behind), scale_.to_paper(face.start + behind)});
  }
  canvas.areas(bodies, kWallBody);
}

Pen MapDrawing::wall_pen(const Wall& wall) const {
  return {wall.is_orthogonal ? kWall : kObliqueWall, std::clamp(0.08 * scale_.px_per_m, 1.75, 3.5)};
}

void MapDrawing::draw_walls(Canvas& canvas, bool is_orthogonal) const {
  for (const Wall& wall : picture_.walls.walls) {
    if (wall.is_orthogonal != is_orthogonal) continue;
    canvas.line(scale_.to_paper(wall.segment.start), scale_.to_paper(wall.segment.end), wall_pen(wall));
  }
}

void MapDrawing::draw_path(Canvas& canvas) const {
  std::vector<Vec2> points;
  for (const Pose2& pose : picture_.path) points.push_back(scale_.to_paper(pose.position()));
  canvas.polyline(simplified(points, kPathTolerance_px), kPathPen);
}

void MapDrawing::draw_loop_closures(Canvas& canvas) const {
  std::vector<std::pair<Vec2, Vec2>> links;
  for (const auto& [a, b] : picture_.loop_closures) {
    links.emplace_back(scale_.to_paper(picture_.path[a].position()),
                       scale_.to_paper(picture_.path[b].position()));
  }
  canvas.lines(links, kLoopPen);
}

void MapDrawing::draw_path_ends(Canvas& canvas) const {
  if (picture_.path.empty()) return;
  const Vec2 start = scale_.to_paper(picture_.path.front().position());
  canvas.disc(start, 7, kPaper);
  canvas.ring(start, 7, {kPath, 2.5});
  canvas.disc(scale_.to_paper(picture_.path.back().position()), 6, kPath);
}

void MapDrawing::draw_header(Canvas& canvas) const {
  const auto fitted = [&](Font font, const std::string& text) {
    const double room_px = scale_.width_px - 2 * kMargin_px;
    font.size_px *= std::min(1.0, room_px / std::max(1.0, canvas.text_width(text, font)));
    return font;
  };
  canvas.text({kMargin_px, 50}, picture_.title, fitted(kTitleFont, picture_.title));
  canvas.text({kMargin_px, 78}, picture_.caption, fitted(kCaptionFont, picture_.caption));
}

void MapDrawing::draw_scale_bar(Canvas& canvas) const {
  const double length_m = round_length(220 / scale_.px_per_m);
  const double left = kMargin_px, right = left + length_m * scale_.px_per_m, y = footer_line();
  const Pen pen{kInk, 2};
  canvas.lines({{{left, y}, {right, y}}, {{left, y - 6}, {left, y + 6}}, {{right, y - 6}, {right, y + 6}}},
               pen);
  canvas.text({right + 14, y + 6}, fmt::format("{:g} m", length_m), kLabelFont);
}

bool MapDrawing::has_wall(bool is_orthogonal) const {
  const auto& walls = picture_.walls.walls;
  return std::any_of(walls.begin(), walls.end(),
                     [&](const Wall& w) { return w.is_orthogonal == is_orthogonal; });
}

/// From right to left, only what the picture shows.
void MapDrawing::draw_legend(Canvas& canvas) const {
  double right = scale_.width_px - kMargin_px;
  const double y = footer_line();
  const auto entry = [&](const std::string& label, double sign_px,
                         const std::function<void(double)>& draw_sign) {
    const double text_x = right - canvas.text_width(label, kLabelFont);
    canvas.text({text_x, y + 6}, label, kLabelFont);
    draw_sign(text_x - 10 - sign_px);
    right = text_x - 10 - sign_px - 30;
  };
  const auto line_entry = [&](const std::string& label, const Pen& pen) {
    entry(label, 30, [&](double x) { canvas.line({x, y}, {x + 30, y}, pen); });
  };
  if (!picture_.loop_closures.empty()) line_entry("loop closures", kLoopPen);
  if (!picture_.path.empty()) {
    entry("end", 12, [&](double x) { canvas.disc({x + 6, y}, 6, kPath); });
    entry("start", 14, [&](double x) { canvas.ring({x + 7, y}, 7, {kPath, 2.5}); });
    line_entry("path", kPathPen);
  }
  if (has_wall(false)) line_entry("oblique wall", {kObliqueWall, 3});
  if (has_wall(true)) line_entry("wall", {kWall, 3});
}

std::string render(const MapPicture& picture, std::string (*make)(int, int, const Drawing&)) {
  const PictureScale scale = fit_scale(picture);
  const MapDrawing drawing(picture, scale);
  return make(scale.width_px, scale.height_px, [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace

std::string svg(const MapPicture& picture) {
  return render(picture, svg_document);
}

std::string png(const MapPicture& picture) {
  return render(picture, png_file);
}

}  // namespace aisle
