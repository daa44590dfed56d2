#include "aisle/report/building_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"
#include "polyline.hpp"

namespace aisle {
namespace {

constexpr Color kSeenFloor{0.93, 0.95, 0.97};
constexpr Color kSeenStanding{0.55, 0.59, 0.64};
constexpr Color kGraphLine{0.80, 0.10, 0.20};
constexpr Color kNamedPlace{0.10, 0.54, 0.30};
constexpr Color kTaughtRoute{0.13, 0.47, 0.86, 0.45};
constexpr Color kDrawnLine{0.90, 0.55, 0.0};
constexpr Color kSeenLandmark{0.45, 0.22, 0.68};

constexpr Pen kCorridorPen{kGraphLine, 3};
constexpr Pen kDrivenPathPen{kPath, 1.25};
constexpr Pen kLearnedWallPen{kInk, 2};
constexpr Pen kUncertainWallPen{{0.13, 0.17, 0.22, 0.35}, 2};
constexpr Pen kTaughtRoutePen{kTaughtRoute, 5};
constexpr Pen kDrawnLinePen{kDrawnLine, 4};
constexpr Pen kZonePen{kDrawnLine, 2};
constexpr Font kRouteFont{15, kPath, true};
constexpr Font kNodeFont{15, kGraphLine, true};
constexpr Font kPlaceFont{15, kNamedPlace, true};
constexpr Font kZoneFont{14, {0.62, 0.36, 0.0}, false};

constexpr double kNode_px = 6;
constexpr double kPlace_px = 5;
constexpr double kLandmark_px = 3;
constexpr double kFaintest = 0.25;
constexpr double kArrow_px = 16;
constexpr double kArrowHead_rad = 150 * kDegree;
constexpr double kTrailTolerance_px = 0.3;

PictureContent content_of(const BuildingPicture& picture) {
  PictureContent content;
  const Building& building = picture.building;
  if (building.floor && !building.floor->known().empty()) {
    const FloorBox& box = building.floor->known();
    const double half_m = building.floor->cell_m() / 2;
    content.add(building.floor->centre(box.low) - Vec2::Constant(half_m));
    content.add(building.floor->centre(box.end) - Vec2::Constant(half_m));
  }
  for (const Wall& wall : building.walls.walls) {
    content.add(wall.segment.start);
    content.add(wall.segment.end);
  }
  for (const Corridor& corridor : building.corridors.corridors) {
    for (const Vec2& p : corridor.path) content.add(p);
  }
  for (const Route& route : building.routes) {
    for (const Vec2& p : points_on(route.path)) content.add(p);
  }
  for (const Landmark& landmark : building.landmarks.all()) {
    if (landmark.weight > 0) content.add(landmark.p_map);
  }
  for (const MapPlace& place : building.places) content.add(place.T_map_place.position());
  for (const Pose2& T : picture.path) content.add(T.position());
  return content;
}

class BuildingDrawing {
 public:
  BuildingDrawing(const BuildingPicture& picture, const PictureScale& scale)
      : picture_(picture), building_(picture.building), scale_(scale) {}

  void draw_on(Canvas& canvas) const {
    canvas.fill(kPaper);
    if (building_.floor) {
      draw_cells(canvas, Floor::kFree, kSeenFloor);
      draw_cells(canvas, Floor::kOccupied, kSeenStanding);
    }
    draw_walls(canvas);
    draw_routes(canvas);
    draw_path(canvas);
    draw_corridors(canvas);
    draw_landmarks(canvas);
    draw_barriers(canvas);
    draw_zones(canvas);
    draw_names(canvas);
    draw_header(canvas, scale_, picture_.title, picture_.caption);
    draw_scale_bar(canvas, scale_);
    draw_legend(canvas);
  }

 private:
  /// Draws runs of equal cells, row by row.
  void draw_cells(Canvas& canvas, Floor kind, const Color& color) const {
    const FloorGrid& floor = *building_.floor;
    const FloorBox& box = floor.known();
    const Vec2 half = Vec2::Constant(floor.cell_m() / 2);
    std::vector<std::array<Vec2, 4>> runs;
    for (int y = box.low.y; y < box.end.y; ++y) {
      for (int x = box.low.x; x < box.end.x; ++x) {
        const int begin = x;
        while (x < box.end.x && floor.at(FloorCell{x, y}) == kind) ++x;
        if (x == begin) continue;
        const Vec2 low = floor.centre({begin, y}) - half, high = floor.centre({x - 1, y}) + half;
        runs.push_back({scale_.to_paper(low), scale_.to_paper({high.x(), low.y()}), scale_.to_paper(high),
                        scale_.to_paper({low.x(), high.y()})});
      }
    }
    canvas.areas(runs, color);
  }

  void draw_walls(Canvas& canvas) const {
    std::vector<std::pair<Vec2, Vec2>> certain, uncertain;
    for (const Wall& wall : building_.walls.walls)
      (wall.is_certain() ? certain : uncertain)
          .emplace_back(scale_.to_paper(wall.segment.start), scale_.to_paper(wall.segment.end));
    canvas.lines(uncertain, kUncertainWallPen);
    canvas.lines(certain, kLearnedWallPen);
  }

  void draw_routes(Canvas& canvas) const {
    for (const Route& route : building_.routes) {
      std::vector<Vec2> points;
      for (const Vec2& p : points_on(route.path)) points.push_back(scale_.to_paper(p));
      canvas.polyline(simplified(points, kTrailTolerance_px), kTaughtRoutePen);
    }
  }

  void draw_landmarks(Canvas& canvas) const {
    for (const Landmark& landmark : building_.landmarks.all()) {
      if (landmark.weight <= 0) continue;
      Color color = kSeenLandmark;
      color.opacity = std::clamp(landmark.weight, kFaintest, 1.0);
      canvas.disc(scale_.to_paper(landmark.p_map), kLandmark_px, color);
    }
  }

  void draw_barriers(Canvas& canvas) const {
    for (const Barrier& barrier : building_.barriers)
      canvas.line(scale_.to_paper(barrier.segment.start), scale_.to_paper(barrier.segment.end),
                  kDrawnLinePen);
  }

  void draw_zones(Canvas& canvas) const {
    for (const Zone& zone : building_.zones) {
      const bool is_keep_out = zone.kind == Zone::Kind::kKeepOut;
      draw_closed(canvas, zone.outline, is_keep_out ? kDrawnLinePen : kZonePen);
      Vec2 p_map = Vec2::Zero();
      for (const Vec2& corner : zone.outline) p_map += corner / static_cast<double>(zone.outline.size());
      const Vec2 centre = scale_.to_paper(p_map);
      if (zone.kind == Zone::Kind::kOneWay) draw_arrow(canvas, centre, zone.direction_rad);
      std::string words = words_for(zone);
      if (zone.kind == Zone::Kind::kSlow) words += fmt::format(", {:.2f} m/s", zone.speed_max_mps);
      canvas.text(centre + Vec2(8, -8), words, kZoneFont);
    }
  }

  void draw_closed(Canvas& canvas, const std::vector<Vec2>& outline, const Pen& pen) const {
    std::vector<Vec2> points;
    points.reserve(outline.size() + 1);
    for (const Vec2& p : outline) points.push_back(scale_.to_paper(p));
    points.push_back(points.front());
    canvas.polyline(points, pen);
  }

  /// On paper, y runs down.
  static void draw_arrow(Canvas& canvas, const Vec2& centre, double direction_rad) {
    const auto away = [&](double length_px, double turn_rad) {
      const double angle_rad = direction_rad + turn_rad;
      return Vec2(length_px * std::cos(angle_rad), -length_px * std::sin(angle_rad));
    };
    const Vec2 tip = centre + away(kArrow_px, 0);
    canvas.line(centre - away(kArrow_px, 0), tip, kZonePen);
    for (const double turn_rad : {kArrowHead_rad, -kArrowHead_rad})
      canvas.line(tip, tip + away(kArrow_px / 2, turn_rad), kZonePen);
  }

  void draw_path(Canvas& canvas) const {
    std::vector<Vec2> points;
    for (const Pose2& T : picture_.path) points.push_back(scale_.to_paper(T.position()));
    canvas.polyline(simplified(points, kTrailTolerance_px), kDrivenPathPen);
  }

  void draw_corridors(Canvas& canvas) const {
    for (const Corridor& corridor : building_.corridors.corridors) {
      std::vector<Vec2> points;
      for (const Vec2& p : corridor.path) points.push_back(scale_.to_paper(p));
      canvas.polyline(points, kCorridorPen);
    }
    for (const CorridorNode& node : building_.corridors.nodes)
      draw_node(canvas, scale_.to_paper(node.p_map), node.kind);
  }

  static void draw_node(Canvas& canvas, const Vec2& centre, CorridorNode::Kind kind) {
    const bool is_crossing = kind == CorridorNode::Kind::kCrossing;
    canvas.disc(centre, kNode_px, is_crossing ? kGraphLine : kPaper);
    canvas.ring(centre, kNode_px, kCorridorPen);
  }

  void draw_names(Canvas& canvas) const {
    const Vec2 beside(kNode_px + 4, -kNode_px);
    const auto& nodes = building_.corridors.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      canvas.text(scale_.to_paper(nodes[i].p_map) + beside, building_.corridors.name_of(i), kNodeFont);
    for (const Route& route : building_.routes) {
      if (route.path.empty()) continue;
      const Vec2 p_start = route.path.at(0).T_map_path.position();
      canvas.text(scale_.to_paper(p_start) + beside, route.name, kRouteFont);
    }
    for (const MapPlace& place : building_.places) {
      const Vec2 centre = scale_.to_paper(place.T_map_place.position());
      canvas.disc(centre, kPlace_px, kNamedPlace);
      canvas.text(centre + Vec2(kPlace_px + 4, 2.5 * kPlace_px), place.name, kPlaceFont);
    }
  }

  /// From right to left, only what the picture contains.
  void draw_legend(Canvas& canvas) const {
    Legend legend(canvas, scale_);
    if (!picture_.path.empty()) legend.add_line("path driven", kDrivenPathPen);
    if (!building_.zones.empty()) legend.add_line("zone", kZonePen);
    if (!building_.barriers.empty()) legend.add_line("keep-out line or glass", kDrawnLinePen);
    if (!building_.landmarks.empty())
      legend.add("landmark", 2 * kLandmark_px,
                 [&](const Vec2& p) { canvas.disc(p, kLandmark_px, kSeenLandmark); });
    if (!building_.routes.empty()) legend.add_line("route", kTaughtRoutePen);
    if (!building_.places.empty())
      legend.add("place", 2 * kPlace_px, [&](const Vec2& p) { canvas.disc(p, kPlace_px, kNamedPlace); });
    if (building_.corridors.count(CorridorNode::Kind::kEnd) > 0)
      legend.add("end", 2 * kNode_px, [&](const Vec2& p) { draw_node(canvas, p, CorridorNode::Kind::kEnd); });
    if (building_.corridors.count(CorridorNode::Kind::kCrossing) > 0)
      legend.add("crossing", 2 * kNode_px,
                 [&](const Vec2& p) { draw_node(canvas, p, CorridorNode::Kind::kCrossing); });
    if (!building_.corridors.corridors.empty()) legend.add_line("corridor", kCorridorPen);
    if (has_walls(false)) legend.add_line("wall seen on one trip", kUncertainWallPen);
    if (has_walls(true)) legend.add_line("wall", kLearnedWallPen);
  }

  bool has_walls(bool certain) const {
    const auto& walls = building_.walls.walls;
    return std::any_of(walls.begin(), walls.end(),
                       [&](const Wall& wall) { return wall.is_certain() == certain; });
  }

  const BuildingPicture& picture_;
  const Building& building_;
  const PictureScale& scale_;
};

std::string render(const BuildingPicture& picture, std::string (*make)(int, int, const Drawing&)) {
  const PictureScale scale = fit_scale(content_of(picture));
  const BuildingDrawing drawing(picture, scale);
  return make(scale.width_px, scale.height_px, [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace

std::string svg(const BuildingPicture& picture) {
  return render(picture, svg_document);
}

std::string png(const BuildingPicture& picture) {
  return render(picture, png_file);
}

}  // namespace aisle
