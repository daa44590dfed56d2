#include "aisle/report/world_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "aisle/simulation/cross_section.hpp"
#include "canvas.hpp"
#include "picture_frame.hpp"
#include "picture_scale.hpp"

namespace aisle {
namespace {

constexpr Color kDoor{0.72, 0.38, 0.10};
constexpr Color kDoorArc{0.72, 0.38, 0.10, 0.45};
constexpr Color kPoster{0.78, 0.12, 0.45};
constexpr Color kNoticeBoard{0.45, 0.22, 0.68};
constexpr Color kLamp{1.0, 0.90, 0.45, 0.75};
constexpr Color kFurniture{0.88, 0.83, 0.74};
constexpr Color kFurnitureEdge{0.52, 0.45, 0.34};
constexpr Color kFrame{0.90, 0.55, 0.0};
constexpr Color kPerson{0.10, 0.58, 0.34};
constexpr Color kPersonPath{0.10, 0.58, 0.34, 0.55};
constexpr Color kTour{0.13, 0.47, 0.86, 0.6};
constexpr Color kBehindText{1, 1, 1, 0.8};

constexpr Font kNameFont{15, kInk};

class WorldDrawing {
 public:
  WorldDrawing(const WorldPicture& picture, const PictureScale& scale)
      : picture_(picture), world_(picture.world), scale_(scale) {}

  void draw_on(Canvas& canvas) const;

 private:
  void draw_lamps(Canvas& canvas) const;
  void draw_papers(Canvas& canvas) const;
  void draw_frames(Canvas& canvas) const;
  void draw_furniture(Canvas& canvas) const;
  void draw_walls(Canvas& canvas) const;
  void draw_door(Canvas& canvas, const Door& door) const;
  void draw_posters(Canvas& canvas) const;
  void draw_people(Canvas& canvas) const;
  void draw_tour(Canvas& canvas) const;
  void draw_start(Canvas& canvas) const;
  void draw_places(Canvas& canvas) const;
  void draw_legend(Canvas& canvas) const;

  std::array<Vec2, 4> corners(const Pose2& T_world_box, const Vec2& size) const;
  void draw_box(Canvas& canvas, const Pose2& T_world_box, const Vec2& size, const Color& color,
                const Pen& edge) const;
  void draw_path(Canvas& canvas, const std::vector<Vec2>& path, const Pen& pen) const;
  void draw_name(Canvas& canvas, const Vec2& p_paper, const std::string& name) const;
  double wall_px() const { return std::clamp(0.05 * scale_.px_per_m, 1.5, 3.5); }

  const WorldPicture& picture_;
  const World& world_;
  const PictureScale& scale_;
};

void WorldDrawing::draw_on(Canvas& canvas) const {
  canvas.fill(kPaper);
  std::vector<Segment2> faces;
  for (const WallFace& wall : world_.walls) faces.push_back(wall.floor_edge);
  draw_wall_bodies(canvas, scale_, faces);
  draw_lamps(canvas);
  draw_papers(canvas);
  draw_frames(canvas);
  draw_furniture(canvas);
  draw_tour(canvas);
  draw_people(canvas);
  draw_walls(canvas);
  for (const Door& door : world_.doors) draw_door(canvas, door);
  draw_posters(canvas);
  draw_start(canvas);
  draw_places(canvas);
  draw_header(canvas, scale_, picture_.title, picture_.caption);
  draw_scale_bar(canvas, scale_);
  draw_legend(canvas);
}

std::array<Vec2, 4> WorldDrawing::corners(const Pose2& T_world_box, const Vec2& size) const {
  const double x = size.x() / 2, y = size.y() / 2;
  std::array<Vec2, 4> corners = {Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)};
  for (Vec2& p : corners) p = scale_.to_paper(T_world_box * p);
  return corners;
}

void WorldDrawing::draw_box(Canvas& canvas, const Pose2& T_world_box, const Vec2& size, const Color& color,
                            const Pen& edge) const {
  const std::array<Vec2, 4> box = corners(T_world_box, size);
  canvas.areas({box}, color);
  canvas.polyline({box[0], box[1], box[2], box[3], box[0]}, edge);
}

void WorldDrawing::draw_lamps(Canvas& canvas) const {
  for (const Lamp& lamp : world_.lamps) {
    draw_box(canvas, {lamp.centre.x(), lamp.centre.y(), lamp.heading_rad}, {lamp.length_m, lamp.width_m},
             kLamp, {kFrame, 0.5});
  }
}

void WorldDrawing::draw_papers(Canvas& canvas) const {
  for (const FloorPaper& paper : world_.papers) {
    draw_box(canvas, {paper.centre.x(), paper.centre.y(), paper.heading_rad}, {paper.length_m, paper.width_m},
             kPaper, {kQuietInk, 1});
  }
}

void WorldDrawing::draw_frames(Canvas& canvas) const {
  for (const ParkingFrame& frame : world_.parking_frames) {
    const Pose2 T_world_frame{frame.centre.x(), frame.centre.y(), frame.heading_rad};
    draw_box(canvas, T_world_frame, frame.size - Vec2::Constant(frame.line_width_m), kPaper,
             {kFrame, std::max(2.0, frame.line_width_m * scale_.px_per_m)});
  }
}

void WorldDrawing::draw_furniture(Canvas& canvas) const {
  constexpr Pen kEdge{kFurnitureEdge, 1};
  for (const Furniture& piece : world_.furniture) {
    const Pose2 T_world_piece{piece.centre.x(), piece.centre.y(), piece.heading_rad};
    const Vec2 p_paper = scale_.to_paper(piece.centre);
    switch (piece.kind) {
      case Furniture::Kind::kBox:
        draw_box(canvas, T_world_piece, piece.size, kFurniture, kEdge);
        break;
      case Furniture::Kind::kPillar:
        canvas.disc(p_paper, piece.size.x() / 2 * scale_.px_per_m, kFurniture);
        canvas.ring(p_paper, piece.size.x() / 2 * scale_.px_per_m, kEdge);
        break;
      case Furniture::Kind::kTable:
        draw_box(canvas, T_world_piece, piece.size, kPaper, kEdge);
        break;
      case Furniture::Kind::kChair: {
        draw_box(canvas, T_world_piece, piece.size, kPaper, kEdge);
        const std::array<Vec2, 4> seat = corners(T_world_piece, piece.size);
        canvas.line(seat[3], seat[0], {kFurnitureEdge, 3});
        break;
      }
    }
  }
}

void WorldDrawing::draw_walls(Canvas& canvas) const {
  std::vector<std::pair<Vec2, Vec2>> ends;
  for (const WallFace& wall : world_.walls) {
    ends.emplace_back(scale_.to_paper(wall.floor_edge.start), scale_.to_paper(wall.floor_edge.end));
  }
  canvas.lines(ends, {kInk, wall_px()});
}

/// The leaf and its opening arc.
void WorldDrawing::draw_door(Canvas& canvas, const Door& door) const {
  constexpr double kStep_rad = 5 * kDegree;
  const auto lock = [&](double open_rad) {
    return scale_.to_paper(door.hinge + door.width_m * unit(door.closed_heading_rad + open_rad));
  };
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(door.open_rad) / kStep_rad)));
  std::vector<Vec2> arc;
  for (int i = 0; i <= steps; ++i) arc.push_back(lock(door.open_rad * i / steps));
  canvas.polyline(arc, {kDoorArc, 1});
  canvas.line(scale_.to_paper(door.hinge), lock(door.open_rad), {kDoor, wall_px() + 1});
}

/// Thick enough to be visible, on the side that they face.
void WorldDrawing::draw_posters(Canvas& canvas) const {
  for (const Poster& poster : world_.posters) {
    const double thickness_px = wall_px() + 2;
    const Vec2 p_front = poster.centre + thickness_px / 2 / scale_.px_per_m * unit(poster.facing_rad);
    const Vec2 half = poster.width_m / 2 * left_normal(unit(poster.facing_rad));
    const bool is_board = poster.kind == Poster::Kind::kNoticeBoard;
    canvas.line(scale_.to_paper(p_front - half), scale_.to_paper(p_front + half),
                {is_board ? kNoticeBoard : kPoster, thickness_px});
  }
}

void WorldDrawing::draw_path(Canvas& canvas, const std::vector<Vec2>& path, const Pen& pen) const {
  std::vector<Vec2> points;
  points.reserve(path.size());
  for (const Vec2& p : path) points.push_back(scale_.to_paper(p));
  canvas.polyline(points, pen);
}

void WorldDrawing::draw_people(Canvas& canvas) const {
  for (const Person& person : world_.people) {
    draw_path(canvas, person.path, {kPersonPath, 1.5});
    canvas.disc(scale_.to_paper(person.path.front()), person.radius_m * scale_.px_per_m, kPerson);
  }
}

void WorldDrawing::draw_tour(Canvas& canvas) const {
  draw_path(canvas, world_.tour, {kTour, 2});
}

/// A ring with a mark in the vehicle's heading.
void WorldDrawing::draw_start(Canvas& canvas) const {
  if (!world_.start) return;
  constexpr Pen kPen{kPath, 2.5};
  const Vec2 centre = scale_.to_paper(world_.start->position());
  const Vec2 ahead = rotate(-world_.start->theta, {1, 0});
  canvas.disc(centre, 8, kPaper);
  canvas.ring(centre, 8, kPen);
  canvas.line(centre, centre + 18 * ahead, kPen);
}

void WorldDrawing::draw_name(Canvas& canvas, const Vec2& p_paper, const std::string& name) const {
  constexpr double kBeside_px = 10, kMargin = 3;
  const double width_px = canvas.text_width(name, kNameFont);
  const bool fits = p_paper.x() + kBeside_px + width_px < scale_.width_px;
  const Vec2 start = p_paper + Vec2(fits ? kBeside_px : -kBeside_px - width_px, 5);
  const Vec2 low = start + Vec2(-kMargin, kMargin),
             high = start + Vec2(width_px + kMargin, -kNameFont.size_px);
  canvas.areas({{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())}}, kBehindText);
  canvas.text(start, name, kNameFont);
}

void WorldDrawing::draw_places(Canvas& canvas) const {
  for (const NamedPlace& place : world_.places) {
    const Vec2 p_paper = scale_.to_paper(place.T_world_place.position());
    canvas.line(p_paper, p_paper + 14 * rotate(-place.T_world_place.theta, {1, 0}), {kInk, 1.5});
    canvas.disc(p_paper, 4.5, kInk);
    draw_name(canvas, p_paper, place.name);
  }
  for (const ParkingFrame& frame : world_.parking_frames) {
    draw_name(canvas, scale_.to_paper(frame.centre) - Vec2(40, 0), frame.name);
  }
}

/// From right to left, only what the picture shows.
void WorldDrawing::draw_legend(Canvas& canvas) const {
  Legend legend(canvas, scale_);
  const auto has_poster = [&](Poster::Kind kind) {
    return std::any_of(world_.posters.begin(), world_.posters.end(),
                       [&](const Poster& poster) { return poster.kind == kind; });
  };
  if (world_.start) legend.add("start", 16, [&](const Vec2& p) { canvas.ring(p, 7, {kPath, 2.5}); });
  if (!world_.tour.empty()) legend.add_line("tour", {kTour, 2});
  if (!world_.people.empty()) legend.add("person", 14, [&](const Vec2& p) { canvas.disc(p, 7, kPerson); });
  if (!world_.lamps.empty()) legend.add_line("lamp", {kLamp, 8});
  if (has_poster(Poster::Kind::kNoticeBoard)) legend.add_line("notice board", {kNoticeBoard, 5});
  if (has_poster(Poster::Kind::kPoster)) legend.add_line("poster", {kPoster, 5});
  if (!world_.doors.empty()) legend.add_line("door", {kDoor, 4});
}

PictureScale fit_scale(const World& world) {
  PictureContent content;
  const auto add = [&](const std::vector<Vec2>& points) {
    for (const Vec2& p : points) content.add(p);
  };
  for (const Segment2& outline : obstacles_below(world, world.ceiling_m)) add({outline.start, outline.end});
  for (const Person& person : world.people) add(person.path);
  for (const NamedPlace& place : world.places) content.add(place.T_world_place.position());
  for (const ParkingFrame& frame : world.parking_frames) content.add(frame.centre);
  if (world.start) content.add(world.start->position());
  add(world.tour);
  return fit_scale(content);
}

std::string render(const WorldPicture& picture, std::string (*make)(int, int, const Drawing&)) {
  const PictureScale scale = fit_scale(picture.world);
  const WorldDrawing drawing(picture, scale);
  return make(scale.width_px, scale.height_px, [&](Canvas& canvas) { drawing.draw_on(canvas); });
}

}  // namespace

std::string svg(const WorldPicture& picture) {
  return render(picture, svg_document);
}

std::string png(const WorldPicture& picture) {
  return render(picture, png_file);
}

}  // namespace aisle
