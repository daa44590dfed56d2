#include "buildings/building_furnishing.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kFreeBehindDoor_m = 1.2;   ///< of the passage through the middle of the doorway
constexpr double kFreeBesideDoor_m = 0.65;  ///< to either side of that passage
constexpr double kFreeRoundTour_m = 0.75;
constexpr double kHallMin_m = 6;  ///< of a corridor's shorter side, to be a hall

bool is_hall(const Rectangle& corridor) {
  return corridor.size().minCoeff() >= kHallMin_m;
}

/// One room with what stands in it already.
class RoomFurnisher {
 public:
  RoomFurnisher(World& world, const Room& room, Random& random)
      : world_(world), room_(room), random_(random) {
    const Vec2 doorway = room.doorway.centre(), free_end = doorway + kFreeBehindDoor_m * room.inwards;
    const Rectangle passage{doorway.cwiseMin(free_end), doorway.cwiseMax(free_end)};
    taken_.push_back(passage.grown(kFreeBesideDoor_m));
  }

  void furnish() {
    const std::size_t tables = 1 + random_.index(2), cupboards = random_.index(3);
    for (std::size_t i = 0; i < tables; ++i) add_table();
    for (std::size_t i = 0; i < cupboards; ++i) add_cupboard();
  }

 private:
  double between(double min_m, double max_m) { return random_centimetres(random_, min_m, max_m); }

  void add_table() {
    const Vec2 size(between(1.2, 1.8), between(0.7, 0.9));
    const Vec2 wall = any_direction();
    const auto place = place_at_wall(wall, size, 0.05);
    if (!place) return;
    const double heading_rad = heading_of(wall) - kPi / 2, brightness = random_.uniform(0.3, 0.8);
    world_.furniture.push_back(
        {Furniture::Kind::kTable, place->centre(), size, heading_rad, 0.74, brightness});
    const double chair_m = 0.45;
    const Vec2 chair = place->centre() - (size.y() / 2 + chair_m / 2) * wall;
    const Rectangle floor = Rectangle{chair, chair}.grown(chair_m / 2);
    if (!is_free(floor)) return;
    taken_.push_back(floor);
    world_.furniture.push_back({Furniture::Kind::kChair, chair, Vec2(chair_m, chair_m), heading_of(wall),
                                0.85, random_.uniform(0.1, 0.4)});
  }

  void add_cupboard() {
    const Vec2 size(between(0.6, 1.2), between(0.35, 0.5)), wall = any_direction();
    const auto place = place_at_wall(wall, size, 0.02);
    if (!place) return;
    world_.furniture.push_back({Furniture::Kind::kBox, place->centre(), size, heading_of(wall) - kPi / 2,
                                between(0.8, 2), random_.uniform(0.3, 0.8)});
  }

  Vec2 any_direction() {
    switch (random_.index(4)) {
      case 0:
        return {1, 0};
      case 1:
        return {0, 1};
      case 2:
        return {-1, 0};
      default:
        return {0, -1};
    }
  }

  /// A random place with its back to the wall in this direction, its width along it; a few are tried.
  std::optional<Rectangle> place_at_wall(const Vec2& wall, const Vec2& size, double gap_m) {
    const Vec2 half = std::abs(wall.x()) > 0.5 ? Vec2(size.y() / 2, size.x() / 2) : Vec2(size / 2);
    const Rectangle inner{room_.floor.min + half + Vec2::Constant(gap_m),
                          room_.floor.max - half - Vec2::Constant(gap_m)};
    if ((inner.size().array() <= 0).any()) return std::nullopt;
    for (int attempt = 0; attempt < 4; ++attempt) {
      Vec2 centre(between(inner.min.x(), inner.max.x()), between(inner.min.y(), inner.max.y()));
      if (wall.x() != 0) centre.x() = wall.x() > 0 ? inner.max.x() : inner.min.x();
      if (wall.y() != 0) centre.y() = wall.y() > 0 ? inner.max.y() : inner.min.y();
      const Rectangle place{centre - half, centre + half};
      if (!is_free(place)) continue;
      taken_.push_back(place);
      return place;
    }
    return std::nullopt;
  }

  bool is_free(const Rectangle& place) const {
    return std::none_of(taken_.begin(), taken_.end(), [&](const Rectangle& t) { return t.overlaps(place); });
  }

  World& world_;
  const Room& room_;
  Random& random_;
  std::vector<Rectangle> taken_;
};

/// Points spread evenly over a floor, at about this distance from each other and half of it from the walls.
std::vector<Vec2> spread_points(const Rectangle& floor, double spacing_m) {
  const int columns = std::max(1, static_cast<int>(std::lround(floor.size().x() / spacing_m)));
  const int rows = std::max(1, static_cast<int>(std::lround(floor.size().y() / spacing_m)));
  const Vec2 step(floor.size().x() / columns, floor.size().y() / rows);
  std::vector<Vec2> points;
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      points.push_back(floor.min + Vec2((column + 0.5) * step.x(), (row + 0.5) * step.y()));
    }
  }
  return points;
}

void add_pillars(World& world, const Rectangle& hall, const BuildingLayout& layout, Random& random) {
  const double spacing_m = random_centimetres(random, 2.8, 4.5),
               diameter_m = random_centimetres(random, 0.3, 0.6);
  const double brightness = random.uniform(0.4, 0.9);
  const auto is_in_the_way = [&](const Vec2& p) {
    for (std::size_t i = 1; i < layout.tour.size(); ++i) {
      if (Segment2{layout.tour[i - 1], layout.tour[i]}.distance(p) < kFreeRoundTour_m + diameter_m / 2)
        return true;
    }
    return false;
  };
  for (const Vec2& p : spread_points(hall, spacing_m)) {
    if (is_in_the_way(p)) continue;
    world.furniture.push_back(
        {Furniture::Kind::kPillar, p, {diameter_m, diameter_m}, 0, world.ceiling_m, brightness});
  }
}

}  // namespace

void hang_doors(World& world, const BuildingLayout& layout, Random& random) {
  const double height_m = random_centimetres(random, 1.98, 2.15);
  const double brightness = random.uniform(0.2, 0.8), frame_brightness = random.uniform(0.1, 0.6);
  const double frame_width_m = random_centimetres(random, 0.05, 0.12);
  for (const Room& room : layout.rooms) {
    if (!room.has_leaf) continue;
    const bool hinge_is_left = with_probability(random, 0.5);
    const Vec2 to_lock = hinge_is_left ? left_normal(room.inwards) * -1 : left_normal(room.inwards);
    const double width_m = room.doorway.size().cwiseProduct(to_lock).norm();
    Door door;
    door.hinge = room.doorway.centre() - to_lock * (width_m / 2);
    door.closed_heading_rad = heading_of(to_lock);
    // The leaf turns into the room: counter-clockwise if that is on the left of the closed leaf.
    const double opening_rad = random.uniform(85, 92) * kDegree;
    if (room.is_open) door.open_rad = left_normal(to_lock).dot(room.inwards) > 0 ? opening_rad : -opening_rad;
    door.width_m = width_m;
    door.height_m = height_m;
    door.brightness = brightness;
    door.frame_width_m = frame_width_m;
    door.frame_brightness = frame_brightness;
    door.wall_depth_m = layout.wall_thickness_m;
    world.doors.push_back(door);
  }
}

void furnish(World& world, const BuildingLayout& layout, Random& random) {
  for (const Room& room : layout.rooms) RoomFurnisher(world, room, random).furnish();
  for (const Rectangle& corridor : layout.corridors) {
    if (is_hall(corridor)) add_pillars(world, corridor, layout, random);
  }
}

void hang_lamps(World& world, const BuildingLayout& layout, Random& random) {
  const double spacing_m = random_centimetres(random, 2, 4.5), power = random.uniform(0.7, 1.3);
  const double broken_share = random.uniform(0, 0.1);
  const bool lie_along = with_probability(random, 0.6);
  const auto hang = [&](const Vec2& p, bool along_x) {
    const bool is_there_already = std::any_of(world.lamps.begin(), world.lamps.end(), [&](const Lamp& lamp) {
      return (lamp.centre - p).norm() < 1.5;
    });
    if (is_there_already || with_probability(random, broken_share)) return;
    world.lamps.push_back({.centre = p, .heading_rad = along_x == lie_along ? 0 : kPi / 2, .power = power});
  };
  for (const Rectangle& corridor : layout.corridors) {
    const bool along_x = corridor.size().x() > corridor.size().y();
    for (const Vec2& p : spread_points(corridor, spacing_m)) hang(p, along_x);
  }
  for (const Room& room : layout.rooms)
    hang(room.floor.centre(), room.floor.size().x() > room.floor.size().y());
}

}  // namespace aisle
