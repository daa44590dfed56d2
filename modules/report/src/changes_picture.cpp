#include "aisle/report/changes_picture.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"

namespace aisle {
namespace {

constexpr Color kBothSaw{0.93, 0.95, 0.97};
constexpr Color kOneSaw{0.985, 0.975, 0.93};
constexpr Color kWonFloor{0.35, 0.75, 0.45};
constexpr Color kLostFloor{0.90, 0.40, 0.35};

constexpr Pen kKeptWallPen{kInk, 2};
constexpr Pen kUncomparedWallPen{{0.68, 0.72, 0.77}, 2};
constexpr Pen kNewWallPen{{0.10, 0.40, 0.86}, 4};
constexpr Pen kGoneWallPen{{0.84, 0.15, 0.18}, 4};
constexpr Pen kMovedFromPen{{0.98, 0.76, 0.45}, 4};
constexpr Pen kMovedToPen{{0.90, 0.45, 0.0}, 4};
constexpr Pen kDoorPen{{0.55, 0.15, 0.65}, 3};

constexpr double kDoorRing_px = 11;
constexpr double kSwatch_px = 16;

constexpr Font kDoorFont{15, {0.55, 0.15, 0.65}, true};

const Pen& pen_of(const ChangedWall& wall) {
  switch (wall.change) {
    case WallChange::kKept:
      return kKeptWallPen;
    case WallChange::kNew:
      return kNewWallPen;
    case WallChange::kGone:
      return kGoneWallPen;
    case WallChange::kMoved:
      return wall.is_of_new ? kMovedToPen : kMovedFromPen;
    case WallChange::kNotCompared:
      break;
  }
  return kUncomparedWallPen;
}

class ChangesDrawing {
 public:
  ChangesDrawing(const ChangesPicture& picture, const PictureScale& scale)
      : picture_(picture), changes_(picture.changes), scale_(scale) {}

  void draw_on(Canvas& canvas) const {
    canvas.fill(kPaper);
    draw_cells(canvas, {FloorChange::kOnlyOld, FloorChange::kOnlyNew}, kOneSaw);
    draw_cells(canvas, {FloorChange::kSame, FloorChange::kWon, FloorChange::kLost}, kBothSaw);
    draw_cells(canvas, {FloorChange::kWon}, kWonFloor);
    draw_cells(canvas, {FloorChange::kLost}, kLostFloor);
    for (const WallChange change : {WallChange::kNotCompared, WallChange::kKept, WallChange::kMoved,
                                    WallChange::kGone, WallChange::kNew})
      draw_walls(canvas, change);
    draw_doors(canvas);
    draw_header(canvas, scale_, picture_.title, picture_.caption);
    draw_scale_bar(canvas, scale_);
    draw_legend(canvas);
  }

 private:
  using Kinds = std::initializer_list<FloorChange>;

  /// Draws runs of cells of some kinds, row by row.
  void draw_cells(Canvas& canvas, Kinds kinds, const Color& color) const {
    const FloorBox& box = changes_.floor.box;
    const auto is_drawn = [&](int x, int y) {
      return std::find(kinds.begin(), kinds.end(), changes_.floor.at({x, y})) != kinds.end();
    };
    std::vector<std::array<Vec2, 4>> runs;
    for (int y = box.low.y; y < box.end.y; ++y) {
      for (int x = box.low.x; x < box.end.x; ++x) {
        const int begin = x;
        while (x < box.end.x && is_drawn(x, y)) ++x;
        if (x == begin) continue;
        const Vec2 low = changes_.floor.cell_m * Vec2(begin, y),
                   high = changes_.floor.cell_m * Vec2(x, y + 1);
        runs.push_back({scale_.to_paper(low), scale_.to_paper({high.x(), low.y()}), scale_.to_paper(high),
                        scale_.to_paper({low.x(), high.y()})});
      }
    }
    canvas.areas(runs, color);
  }

  void draw_walls(Canvas& canvas, WallChange change) const {
    for (const bool is_of_new : {false, true}) {
      if (change == WallChange::kKept && !is_of_new) continue;  // as the new map shows them
      std::vector<std::pair<Vec2, Vec2>> lines;
      for (const ChangedWall& wall : changes_.walls) {
        if (wall.change == change && wall.is_of_new == is_of_new)
          lines.emplace_back(scale_.to_paper(wall.segment.start), scale_.to_paper(wall.segment.end));
      }
      canvas.lines(lines, pen_of({.change = change, .is_of_new = is_of_new}));
    }
  }

  void draw_doors(Canvas& canvas) const {
    for (const DoorChange& door : changes_.doors) {
      const Vec2 centre = scale_.to_paper(door.opening.midpoint());
      canvas.ring(centre, kDoorRing_px, kDoorPen);
      canvas.text(centre + Vec2(kDoorRing_px + 4, -4), door.is_open ? "opened" : "shut", kDoorFont);
    }
  }

  bool has(WallChange change) const {
    return std::any_of(changes_.walls.begin(), changes_.walls.end(),
                       [&](const ChangedWall& wall) { return wall.change == change; });
  }

  static void add_swatch(Legend& legend, Canvas& canvas, const std::string& label, const Color& color) {
    legend.add(label, kSwatch_px, [&](const Vec2& p) {
      const double half = kSwatch_px / 2;
      canvas.areas(
          {{p + Vec2(-half, -half), p + Vec2(half, -half), p + Vec2(half, half), p + Vec2(-half, half)}},
          color);
    });
  }

  /// From right to left, only what the picture contains.
  void draw_legend(Canvas& canvas) const {
    Legend legend(canvas, scale_);
    const auto area_m2 = [&](FloorChange change) { return changes_.floor.area_m2(change); };
    if (area_m2(FloorChange::kOnlyOld) + area_m2(FloorChange::kOnlyNew) > 0)
      add_swatch(legend, canvas, "floor that one map knows", kOneSaw);
    if (area_m2(FloorChange::kLost) > 0) add_swatch(legend, canvas, "floor lost", kLostFloor);
    if (area_m2(FloorChange::kWon) > 0) add_swatch(legend, canvas, "floor won", kWonFloor);
    if (!changes_.doors.empty())
      legend.add("door", 2 * kDoorRing_px, [&](const Vec2& p) { canvas.ring(p, kDoorRing_px, kDoorPen); });
    if (has(WallChange::kNotCompared)) legend.add_line("wall not compared", kUncomparedWallPen);
    if (has(WallChange::kMoved)) {
      legend.add_line("moved to", kMovedToPen);
      legend.add_line("moved from", kMovedFromPen);
    }
    if (has(WallChange::kGone)) legend.add_line("wall gone", kGoneWallPen);
    if (has(WallChange::kNew)) legend.add_line("new wall", kNewWallPen);
    if (has(WallChange::kKept)) legend.add_line("wall of both maps", kKeptWallPen);
  }

  const ChangesPicture& picture_;
  const BuildingChanges& changes_;
  const PictureScale& scale_;
};

std::string render_changes(const ChangesPicture& picture, std::string (*make)(int, int, const Drawing&)) {
  PictureContent content;
  for (const ChangedWall& wall : picture.changes.walls) {
    content.add(wall.segment.start);
    content.add(wall.segment.end);
  }
  const FloorChanges& floor = picture.changes.floor;
  if (!floor.box.empty()) {
    content.add(floor.cell_m * Vec2(floor.box.low.x, floor.box.low.y));
    content.add(floor.cell_m * Vec2(floor.box.end.x, floor.box.end.y));
  }
  const PictureScale scale = fit_scale(content);
  const ChangesDrawing drawing(picture, scale);
  return make(scale.width_px, scale.height_px, [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace

std::string svg(const ChangesPicture& picture) {
  return render_changes(picture, svg_document);
}

std::string png(const ChangesPicture& picture) {
  return render_changes(picture, png_file);
}

}  // namespace aisle
