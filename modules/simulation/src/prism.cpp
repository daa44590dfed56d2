#include "prism.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kDoorThickness_m = 0.04;
constexpr double kLegThickness_m = 0.04;
constexpr double kBackThickness_m = 0.04;
constexpr double kChairSeat_m = 0.45;
constexpr double kPlateThickness_m = 0.03;
constexpr int kPillarSides = 24;

std::vector<Prism> plate_on_legs(const Pose2& T_world_plate, const Vec2& size, double top_m) {
  const double bottom_m = std::max(0.0, top_m - kPlateThickness_m);
  std::vector<Prism> parts = {box(T_world_plate, size, bottom_m, top_m)};
  const Vec2 leg = (size - Vec2::Constant(kLegThickness_m)) / 2;
  for (const double x : {-leg.x(), leg.x()}) {
    for (const double y : {-leg.y(), leg.y()}) {
      parts.push_back(box(T_world_plate * Pose2{x, y, 0}, Vec2::Constant(kLegThickness_m), 0, bottom_m));
    }
  }
  return parts;
}

}  // namespace

Prism box(const Pose2& T_world_box, const Vec2& size, double bottom_m, double top_m) {
  const double x = size.x() / 2, y = size.y() / 2;
  return {{T_world_box * Vec2(-x, -y), T_world_box * Vec2(-x, y), T_world_box * Vec2(x, y),
           T_world_box * Vec2(x, -y)},
          bottom_m,
          top_m};
}

Prism pillar(const Pose2& T_world_pillar, const Vec2& size, double bottom_m, double top_m, int sides) {
  Prism prism{{}, bottom_m, top_m};
  for (int i = 0; i < sides; ++i) {
    prism.outline.push_back(T_world_pillar * Vec2(unit(-2 * kPi * i / sides).cwiseProduct(size) / 2));
  }
  return prism;
}

std::vector<Prism> parts_of(const Furniture& piece) {
  const Pose2 T_world_piece{piece.centre.x(), piece.centre.y(), piece.heading_rad};
  switch (piece.kind) {
    case Furniture::Kind::kBox:
      return {box(T_world_piece, piece.size, 0, piece.height_m)};
    case Furniture::Kind::kPillar:
      return {pillar({piece.centre.x(), piece.centre.y(), 0}, Vec2::Constant(piece.size.x()), 0,
                     piece.height_m, kPillarSides)};
    case Furniture::Kind::kTable:
      return plate_on_legs(T_world_piece, piece.size, piece.height_m);
    case Furniture::Kind::kChair: {
      const double seat_m = std::min(kChairSeat_m, piece.height_m);
      std::vector<Prism> parts = plate_on_legs(T_world_piece, piece.size, seat_m);
      const double x_m = -(piece.size.x() - kBackThickness_m) / 2;
      parts.push_back(
          box(T_world_piece * Pose2{x_m, 0, 0}, {kBackThickness_m, piece.size.y()}, seat_m, piece.height_m));
      return parts;
    }
  }
  return {};
}

Prism leaf_of(const Door& door) {
  const Pose2 T_world_hinge{door.hinge.x(), door.hinge.y(), door.closed_heading_rad + door.open_rad};
  return box(T_world_hinge * Pose2{door.width_m / 2, 0, 0}, {door.width_m, kDoorThickness_m}, 0,
             door.height_m);
}

std::vector<Prism> frame_posts_of(const Door& door) {
  if (door.frame_width_m <= 0) return {};
  const Pose2 T_world_closed{door.hinge.x(), door.hinge.y(), door.closed_heading_rad};
  const double depth_m = door.wall_depth_m + 2 * kFrameRelief_m;
  const double post_m = door.frame_width_m + kFrameInside_m;
  std::vector<Prism> posts;
  for (const double x : {kFrameInside_m - post_m / 2, door.width_m - kFrameInside_m + post_m / 2}) {
    posts.push_back(
        box(T_world_closed * Pose2{x, 0, 0}, {post_m, depth_m}, 0, door.height_m + door.frame_width_m));
  }
  return posts;
}

}  // namespace aisle
