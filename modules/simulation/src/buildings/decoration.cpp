#include "aisle/simulation/buildings/decoration.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/simulation/wall_grid.hpp"

namespace aisle {
namespace {

constexpr double kFromCorner_m = 0.3;
constexpr double kFreeAhead_m = 0.7;  ///< space to pass a door or to look at a poster
constexpr double kSeenFromTour_m = 4;
constexpr double kLampApart_m = 2;
constexpr double kLampStep_m = 0.25;  ///< between places along the tour that may get a lamp

bool is_near_tour(const World& world, const Vec2& p) {
  return std::any_of(world.tour.begin(), world.tour.end() - 1, [&](const Vec2& start) {
    return Segment2{start, *(&start + 1)}.distance(p) < kSeenFromTour_m;
  });
}

std::vector<Segment2> wall_lines(const World& world) {
  std::vector<Segment2> wall_lines;
  for (const WallFace& wall : world.walls) wall_lines.push_back(wall.floor_edge);
  return wall_lines;
}

/// What hangs on the walls already, as circles on the floor.
class Occupied {
 public:
  explicit Occupied(const World& world) {
    for (const Door& door : world.doors) {
      add(door.hinge + door.width_m / 2 * unit(door.closed_heading_rad),
          door.width_m / 2 + door.frame_width_m);
    }
    for (const Poster& poster : world.posters) add(poster.centre, poster.width_m / 2);
  }

  void add(const Vec2& centre, double radius_m) { circles_.push_back({centre, radius_m}); }

  bool is_free(const Vec2& centre, double radius_m) const {
    return std::none_of(circles_.begin(), circles_.end(), [&](const Circle& c) {
      return (c.centre - centre).norm() < c.radius_m + radius_m + 0.1;
    });
  }

 private:
  struct Circle {
    Vec2 centre;
    double radius_m;
  };
  std::vector<Circle> circles_;
};

/// A part of a wall that something of this width could hang on, in the middle of a visible part.
struct Spot {
  Vec2 centre = Vec2::Zero();
  Vec2 along = Vec2::UnitX();
};

/// Walks along the walls and offers spots at random distances.
class WallWalk {
 public:
  WallWalk(const World& world, Random& random)
      : grid_(wall_lines(world)), walls_(wall_lines(world)), random_(random) {}

  /// @param next  distance to go on before a spot and its width are drawn
  template <class Draw, class Hang>
  void offer_spots(double spacing_min_m, double spacing_max_m, Draw draw_width_m, Hang hang) {
    for (const Segment2& wall : walls_) {
      const Vec2 along = (wall.end - wall.start).normalized();
      double at_m = kFromCorner_m + random_.uniform(0, spacing_min_m);
      while (true) {
        const double width_m = draw_width_m();
        if (at_m + width_m + kFromCorner_m > wall.length()) break;
        const Spot spot{wall.start + (at_m + width_m / 2) * along, along};
        if (is_seen(spot, width_m)) hang(spot, width_m);
        at_m += width_m + random_.uniform(spacing_min_m, spacing_max_m);
      }
    }
  }

 private:
  bool is_seen(const Spot& spot, double width_m) const {
    const Vec2 ahead = left_normal(spot.along);
    for (const double side : {-0.5, 0.0, 0.5}) {
      if (grid_.cast(spot.centre + side * width_m * spot.along + 0.01 * ahead, ahead) < kFreeAhead_m)
        return false;
    }
    return true;
  }

  WallGrid grid_;
  std::vector<Segment2> walls_;
  Random& random_;
};

void mount_doors(World& world, Random& random) {
  Occupied occupied(world);
  const double brightness = random.uniform(0.2, 0.8), frame_brightness = random.uniform(0.1, 0.6);
  const auto hang = [&](const Spot& spot, double width_m) {
    if (!occupied.is_free(spot.centre, width_m / 2) || !is_near_tour(world, spot.centre)) return;
    occupied.add(spot.centre, width_m / 2);
    world.doors.push_back({.hinge = spot.centre - width_m / 2 * spot.along,
                           .closed_heading_rad = heading_of(spot.along),
                           .width_m = width_m,
                           .brightness = brightness,
                           .frame_brightness = frame_brightness});
  };
  WallWalk(world, random)
      .offer_spots(
          2, 5, [&] { return std::round(random.uniform(80, 100)) / 100; }, hang);
}

void hang_lamps_over_tour(World& world, Random& random) {
  const double spacing_m = random.uniform(2.5, 4);
  double since_m = spacing_m;
  for (std::size_t i = 1; i < world.tour.size(); ++i) {
    const Segment2 leg{world.tour[i - 1], world.tour[i]};
    const int steps = static_cast<int>(std::ceil(leg.length() / kLampStep_m));
    for (int step = 0; step < steps; ++step, since_m += kLampStep_m) {
      const Vec2 p = leg.start + step * kLampStep_m * (leg.end - leg.start).normalized();
      const bool has_light = std::any_of(world.lamps.begin(), world.lamps.end(), [&](const Lamp& lamp) {
        return (lamp.centre - p).norm() < kLampApart_m;
      });
      if (since_m < spacing_m || has_light) continue;
      world.lamps.push_back({.centre = p, .heading_rad = leg.heading()});
      since_m = 0;
    }
  }
}

}  // namespace

void hang_posters(World& world, Random& random) {
  Occupied occupied(world);
  const double share = random.uniform(0.2, 0.8);
  const auto hang = [&](const Spot& spot, double width_m) {
    if (random.uniform() > share || !occupied.is_free(spot.centre, width_m / 2)) return;
    occupied.add(spot.centre, width_m / 2);
    const bool is_board = width_m > 0.9;
    const Vec2 facing = left_normal(spot.along);
    world.posters.push_back({.kind = is_board ? Poster::Kind::kNoticeBoard : Poster::Kind::kPoster,
                             .centre = spot.centre,
                             .facing_rad = heading_of(facing),
                             .width_m = width_m,
                             .height_m = is_board ? 0.9 : std::round(width_m * 141) / 100,
                             .bottom_m = 1.1});
  };
  WallWalk(world, random)
      .offer_spots(
          1, 4, [&] { return std::round(random.uniform(30, 120)) / 100; }, hang);
}

void dress(World& world, Random random) {
  if (world.tour.size() > 1) {
    mount_doors(world, random);
    hang_lamps_over_tour(world, random);
  }
  hang_posters(world, random);
}

}  // namespace aisle
