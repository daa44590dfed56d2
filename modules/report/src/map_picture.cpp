#include "aisle/report/map_picture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"
#include "polyline.hpp"

namespace aisle {
namespace {

constexpr Color kGrid{0.93, 0.945, 0.96};
constexpr Color kObliqueWall{0.78, 0.36, 0.08};
constexpr Color kLoopClosure{0.10, 0.64, 0.36, 0.85};

constexpr Pen kPathPen{kPath, 1.75};
constexpr Pen kLoopPen{kLoopClosure, 2};
constexpr Pen kGridPen{kGrid, 1};

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
  void draw_legend(Canvas& canvas) const;

  Pen wall_pen(const Wall& wall) const;
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
  draw_header(canvas, scale_, picture_.title, picture_.caption);
  draw_scale_bar(canvas, scale_);
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

void MapDrawing::draw_wall_bodies(Canvas& canvas) const {
  std::vector<Segment2> faces;
  for (const Wall& wall : picture_.walls.walls) faces.push_back(wall.segment);
  aisle::draw_wall_bodies(canvas, scale_, faces);
}

Pen MapDrawing::wall_pen(const Wall& wall) const {
  return {wall.is_orthogonal ? kInk : kObliqueWall, std::clamp(0.08 * scale_.px_per_m, 1.75, 3.5)};
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

bool MapDrawing::has_wall(bool is_orthogonal) const {
  const auto& walls = picture_.walls.walls;
  return std::any_of(walls.begin(), walls.end(),
                     [&](const Wall& w) { return w.is_orthogonal == is_orthogonal; });
}

/// From right to left, only what the picture contains.
void MapDrawing::draw_legend(Canvas& canvas) const {
  Legend legend(canvas, scale_);
  if (!picture_.loop_closures.empty()) legend.add_line("loop closures", kLoopPen);
  if (!picture_.path.empty()) {
    legend.add("end", 12, [&](const Vec2& p) { canvas.disc(p, 6, kPath); });
    legend.add("start", 14, [&](const Vec2& p) { canvas.ring(p, 7, {kPath, 2.5}); });
    legend.add_line("path", kPathPen);
  }
  if (has_wall(false)) legend.add_line("oblique wall", {kObliqueWall, 3});
  if (has_wall(true)) legend.add_line("wall", {kInk, 3});
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
