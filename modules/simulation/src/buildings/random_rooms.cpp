#include <algorithm>
#include <cmath>

#include "buildings/building_layout.hpp"

namespace aisle {
namespace {

constexpr double kRoomWidthMin_m = 2.6;
constexpr double kRoomWidthMax_m = 6.5;
constexpr double kRoomDepthMin_m = 2.4;
constexpr double kRoomDepthMax_m = 6;
constexpr double kShallower_m = 0.6;  ///< less depth where something is behind
constexpr double kDoorFromCorner_m = 0.2;
constexpr double kWallSlack_m = 1e-3;

/// A straight wall of a corridor: s along it, d behind it, from where it starts.
struct Frontage {
  Segment2 wall;

  Vec2 along() const { return (wall.end - wall.start).normalized(); }
  Vec2 behind() const { return -left_normal(along()); }
  Vec2 point(double s_m, double d_m) const { return wall.start + s_m * along() + d_m * behind(); }
  Rectangle rectangle(double s_m, double width_m, double d_m, double depth_m) const {
    const Vec2 a = point(s_m, d_m), b = point(s_m + width_m, d_m + depth_m);
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }
};

class RoomPlanner {
 public:
  RoomPlanner(BuildingLayout& layout, Random& random) : layout_(layout), random_(random) {
    room_share_ = random.uniform(0.6, 0.95);
    open_share_ = random.uniform(0.2, 0.6);
    alcove_share_ = random.uniform(0, 0.15);
  }

  void line_all() {
    for (const Segment2& wall : walls_around(layout_.corridors)) line({wall});
    if (std::none_of(layout_.rooms.begin(), layout_.rooms.end(), [](const Room& r) { return r.is_open; }) &&
        !layout_.rooms.empty()) {
      layout_.rooms.front().is_open = true;
    }
  }

 private:
  double between(double min_m, double max_m) { return random_centimetres(random_, min_m, max_m); }

  void line(const Frontage& frontage) {
    const double end_m = frontage.wall.length();
    double at_m = with_probability(random_, 0.5) ? 0 : between(0.2, 1.5);
    while (at_m + kRoomWidthMin_m < end_m) {
      const double dice = random_.uniform();
      double taken_m = 0;
      if (dice < room_share_) {
        taken_m = add_room(frontage, at_m, end_m);
      } else if (dice < room_share_ + alcove_share_) {
        taken_m = add_alcove(frontage, at_m + 0.3, end_m - 0.3);
      }
      at_m += taken_m > 0 ? taken_m + layout_.wall_thickness_m : between(0.5, 2);
    }
  }

  /// The width that it takes; 0 if it does not fit.
  double add_room(const Frontage& frontage, double at_m, double end_m) {
    const double width_m = std::min(between(kRoomWidthMin_m, kRoomWidthMax_m), end_m - at_m);
    const double wall_m = layout_.wall_thickness_m;
    const double wanted_m = between(kRoomDepthMin_m, kRoomDepthMax_m);
    const double doorway_m = between(0.92, 1.1);
    const int shallower = static_cast<int>((wanted_m - kRoomDepthMin_m) / kShallower_m);
    for (int attempt = 0; attempt <= shallower; ++attempt) {
      const double depth_m = wanted_m - attempt * kShallower_m;
      const Rectangle floor = frontage.rectangle(at_m, width_m, wall_m, depth_m);
      if (!is_apart(floor)) continue;
      const double door_m = at_m + between(kDoorFromCorner_m, width_m - kDoorFromCorner_m - doorway_m);
      Room room{floor, frontage.rectangle(door_m, doorway_m, 0, wall_m), frontage.behind()};
      room.is_open = with_probability(random_, open_share_);
      room.has_leaf = !room.is_open || with_probability(random_, 0.75);
      layout_.rooms.push_back(room);
      return width_m;
    }
    return 0;
  }

  double add_alcove(const Frontage& frontage, double at_m, double end_m) {
    const double width_m = between(0.7, 2.2), depth_m = between(0.2, 1);
    const Rectangle alcove = frontage.rectangle(at_m, width_m, 0, depth_m);
    const Rectangle behind_wall = frontage.rectangle(at_m, width_m, layout_.wall_thickness_m, depth_m);
    if (at_m + width_m > end_m || !is_apart(behind_wall)) return 0;
    layout_.alcoves.push_back(alcove);
    return width_m + 0.6;
  }

  /// Whether there is at least one wall between this and all other floor.
  bool is_apart(const Rectangle& floor) const {
    const Rectangle with_walls = floor.grown(layout_.wall_thickness_m - kWallSlack_m);
    const auto overlaps = [&](const Rectangle& other) { return with_walls.overlaps(other); };
    return std::none_of(layout_.corridors.begin(), layout_.corridors.end(), overlaps) &&
           std::none_of(layout_.alcoves.begin(), layout_.alcoves.end(), overlaps) &&
           std::none_of(layout_.rooms.begin(), layout_.rooms.end(),
                        [&](const Room& room) { return overlaps(room.floor); });
  }

  BuildingLayout& layout_;
  Random& random_;
  double room_share_ = 0.8;
  double open_share_ = 0.4;
  double alcove_share_ = 0.1;
};

}  // namespace

std::vector<Rectangle> BuildingLayout::floor() const {
  std::vector<Rectangle> floor = corridors;
  floor.insert(floor.end(), alcoves.begin(), alcoves.end());
  for (const Room& room : rooms) {
    floor.push_back(room.floor);
    floor.push_back(room.doorway);
  }
  return floor;
}

void add_rooms(BuildingLayout& layout, Random& random) {
  RoomPlanner(layout, random).line_all();
}

}  // namespace aisle
