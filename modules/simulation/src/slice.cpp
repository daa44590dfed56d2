#include "aisle/simulation/slice.hpp"

#include <array>
#include <cmath>

namespace aisle {
namespace {

constexpr double kDoorThickness_m = 0.04;
constexpr double kLegThickness_m = 0.04;
constexpr double kBackThickness_m = 0.04;
constexpr double kChairSeat_m = 0.45;
constexpr double kPlateThickness_m = 0.03;
constexpr int kPillarSides = 24;

/// Heights between which something is looked for [m].
struct Layer {
  double bottom_m = 0;
  double top_m = 0;

  bool touches(double bottom, double top) const { return bottom <= top_m && top >= bottom_m; }
};

class Outlines {
 public:
  explicit Outlines(Layer layer) : layer_(layer) {}

  void add(const WallFace& wall) {
    if (layer_.touches(0, wall.height_m)) segments_.push_back(wall.foot);
  }

  void add(const Door& door) {
    if (layer_.touches(0, door.height_m)) {
      const Pose2 T_world_leaf{door.hinge.x(), door.hinge.y(), door.closed_heading_rad + door.open_rad};
      add_box(T_world_leaf * Pose2{door.width_m / 2, 0, 0}, {door.width_m, kDoorThickness_m});
    }
  }

  void add(const Furniture& piece) {
    const Pose2 T_world_piece{piece.centre.x(), piece.centre.y(), piece.heading_rad};
    switch (piece.kind) {
      case Furniture::Kind::kBox:
        if (layer_.touches(0, piece.height_m)) add_box(T_world_piece, piece.size);
        return;
      case Furniture::Kind::kPillar:
        if (layer_.touches(0, piece.height_m)) add_pillar(piece.centre, piece.size.x() / 2);
        return;
      case Furniture::Kind::kTable:
        add_plate_on_legs(T_world_piece, piece.size, piece.height_m);
        return;
      case Furniture::Kind::kChair: {
        const double seat_m = std::min(kChairSeat_m, piece.height_m);
        add_plate_on_legs(T_world_piece, piece.size, seat_m);
        const double x_m = -(piece.size.x() - kBackThickness_m) / 2;
        if (layer_.touches(seat_m, piece.height_m)) {
          add_box(T_world_piece * Pose2{x_m, 0, 0}, {kBackThickness_m, piece.size.y()});
        }
        return;
      }
    }
  }

  std::vector<Segment2> take() && { return std::move(segments_); }

 private:
  void add_plate_on_legs(const Pose2& T_world_plate, const Vec2& size, double top_m) {
    if (layer_.touches(top_m - kPlateThickness_m, top_m)) {
      add_box(T_world_plate, size);
    } else if (layer_.touches(0, top_m)) {
      const Vec2 leg = (size - Vec2::Constant(kLegThickness_m)) / 2;
      for (const double x : {-leg.x(), leg.x()}) {
        for (const double y : {-leg.y(), leg.y()}) {
          add_box(T_world_plate * Pose2{x, y, 0}, Vec2::Constant(kLegThickness_m));
        }
      }
    }
  }

  /// Clockwise: the outside, where one can drive, is on the left.
  void add_box(const Pose2& T_world_box, const Vec2& size) {
    const double x = size.x() / 2, y = size.y() / 2;
    const std::array<Vec2, 4> corners = {Vec2(-x, -y), Vec2(-x, y), Vec2(x, y), Vec2(x, -y)};
    for (std::size_t i = 0; i < 4; ++i) {
      segments_.push_back(T_world_box * Segment2{corners[i], corners[(i + 1) % 4]});
    }
  }

  void add_pillar(const Vec2& centre, double radius_m) {
    const auto corner = [&](int i) -> Vec2 { return centre + radius_m * unit(-2 * kPi * i / kPillarSides); };
    for (int i = 0; i < kPillarSides; ++i) segments_.push_back({corner(i), corner(i + 1)});
  }

  Layer layer_;
  std::vector<Segment2> segments_;
};

std::vector<Segment2> outlines(const World& world, Layer layer) {
  Outlines outlines(layer);
  for (const WallFace& wall : world.walls) outlines.add(wall);
  for (const Door& door : world.doors) outlines.add(door);
  for (const Furniture& piece : world.furniture) outlines.add(piece);
  return std::move(outlines).take();
}

}  // namespace

std::vector<Segment2> slice(const World& world, double height_m) {
  return outlines(world, {height_m, height_m});
}

std::vector<Segment2> obstacles_below(const World& world, double height_m) {
  return outlines(world, {0, height_m});
}

}  // namespace aisle
