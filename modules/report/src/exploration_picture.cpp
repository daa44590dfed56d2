#include "aisle/report/exploration_picture.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"
#include "polyline.hpp"

namespace aisle {
namespace {

constexpr Color kExploredFloor{1, 1, 1};
constexpr Color kUnseenFloor{0.90, 0.91, 0.92};
constexpr Color kExploredObstacles{0.42, 0.45, 0.50};
constexpr Color kPushed{0.95, 0.60, 0.10};
constexpr Color kGivenUp{0.55, 0.40, 0.65};
constexpr Color kUndone{0.80, 0.10, 0.20};
constexpr Pen kExploredWallPen{kInk, 2};
constexpr Pen kExploredPathPen{kPath, 2.5};
constexpr double kFrontier_px = 6;

class ExplorationDrawing {
 public:
  ExplorationDrawing(const ExplorationPicture& picture, const PictureScale& scale)
      : picture_(picture), scale_(scale) {
    for (const PathEvent& event : picture.record.paths) latest_[event.path] = &event;
  }

  void draw_on(Canvas& canvas) const {
    canvas.fill(kUnseenFloor);
    canvas.areas(cells_of(Floor::kFree), kExploredFloor);
    canvas.areas(cells_of(Floor::kOccupied), kExploredObstacles);
    draw_walls(canvas);
    draw_path(canvas);
    draw_frontiers(canvas);
    draw_header(canvas, scale_, picture_.title, picture_.caption);
    draw_scale_bar(canvas, scale_);
    draw_legend(canvas);
  }

 private:
  /// The cells of one kind, row by row, with neighbours merged into one area.
  std::vector<std::array<Vec2, 4>> cells_of(Floor kind) const {
    std::vector<std::array<Vec2, 4>> areas;
    const FloorBox& known = picture_.floor.known();
    for (int y = known.low.y; y < known.end.y; ++y) {
      for (int x = known.low.x; x < known.end.x; ++x) {
        if (picture_.floor.at(FloorCell{x, y}) != kind) continue;
        const int first = x;
        while (picture_.floor.at(FloorCell{x + 1, y}) == kind) ++x;
        areas.push_back(area(first, x + 1, y));
      }
    }
    return areas;
  }

  std::array<Vec2, 4> area(int first, int end, int row) const {
    const double cell_m = picture_.floor.cell_m();
    const Vec2 low = scale_.to_paper({first * cell_m, row * cell_m});
    const Vec2 high = scale_.to_paper({end * cell_m, (row + 1) * cell_m});
    return {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())};
  }

  void draw_walls(Canvas& canvas) const {
    std::vector<std::pair<Vec2, Vec2>> ends;
    for (const Wall& wall : picture_.walls.walls)
      ends.emplace_back(scale_.to_paper(wall.segment.start), scale_.to_paper(wall.segment.end));
    canvas.lines(ends, kExploredWallPen);
  }

  void draw_path(Canvas& canvas) const {
    constexpr double kTolerance_px = 0.3;
    std::vector<Vec2> points;
    for (const Pose2& pose : picture_.T_map_vehicle) points.push_back(scale_.to_paper(pose.position()));
    if (points.empty()) return;
    canvas.polyline(simplified(points, kTolerance_px), kExploredPathPen);
    canvas.disc(points.front(), kFrontier_px, kPath);
  }

  void draw_frontiers(Canvas& canvas) const {
    for (const auto& [path, event] : latest_)
      draw_frontier(canvas, scale_.to_paper(event->p_map), event->kind);
  }

  static void draw_frontier(Canvas& canvas, const Vec2& centre, PathEvent::Kind kind) {
    if (kind == PathEvent::Kind::kPushed) canvas.ring(centre, kFrontier_px, {kPushed, 2});
    if (kind == PathEvent::Kind::kGivenUp) canvas.disc(centre, kFrontier_px, kGivenUp);
    if (kind == PathEvent::Kind::kAbandoned) canvas.disc(centre, kFrontier_px, kUndone);
  }

  void draw_legend(Canvas& canvas) const {
    Legend legend(canvas, scale_);
    const auto add_frontier = [&](const char* label, PathEvent::Kind kind) {
      const bool is_shown = std::any_of(latest_.begin(), latest_.end(),
                                        [&](const auto& path) { return path.second->kind == kind; });
      if (is_shown)
        legend.add(label, 2 * kFrontier_px, [&](const Vec2& p) { draw_frontier(canvas, p, kind); });
    };
    add_frontier("left undone", PathEvent::Kind::kAbandoned);
    add_frontier("corner given up", PathEvent::Kind::kGivenUp);
    add_frontier("path not taken yet", PathEvent::Kind::kPushed);
    legend.add_line("path driven", kExploredPathPen);
    legend.add_line("walls", kExploredWallPen);
  }

  const ExplorationPicture& picture_;
  const PictureScale& scale_;
  std::map<std::size_t, const PathEvent*> latest_;  ///< of each path
};

PictureScale fit_scale(const ExplorationPicture& picture) {
  PictureContent content;
  const FloorBox& known = picture.floor.known();
  if (!known.empty()) {
    content.add(picture.floor.centre(known.low));
    content.add(picture.floor.centre(known.end));
  }
  return fit_scale(content);
}

std::string render(const ExplorationPicture& picture, std::string (*make)(int, int, const Drawing&)) {
  const PictureScale scale = fit_scale(picture);
  const ExplorationDrawing drawing(picture, scale);
  return make(scale.width_px, scale.height_px, [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace

std::string svg(const ExplorationPicture& picture) {
  return render(picture, svg_document);
}

std::string png(const ExplorationPicture& picture) {
  return render(picture, png_file);
}

}  // namespace aisle
