#include "rendering/scene_plan.hpp"

namespace aisle {
namespace {

constexpr double kPlasterBrightness = 0.75;

/// Two posts and a beam around the opening, a little proud of the wall.
void add_frame(const Door& door, const Pose2& T_world_closed, int material, Panels& panels) {
  const double depth_m = door.wall_depth_m + 2 * kFrameRelief_m;
  for (const Prism& post : frame_posts_of(door)) add_prism(post, material, panels);
  const double opening_m = door.width_m - 2 * kFrameInside_m;
  add_prism(box(T_world_closed * Pose2{door.width_m / 2, 0, 0}, {opening_m, depth_m},
                door.height_m - kFrameInside_m, door.height_m + door.frame_width_m),
            material, panels);
}

/// How bright the wall is that the door is in: as the nearest piece of wall.
double wall_brightness(const World& world, const Door& door) {
  double nearest_m = 1, brightness = kPlasterBrightness;
  for (const WallFace& wall : world.walls) {
    for (const Vec2& end : {wall.floor_edge.start, wall.floor_edge.end}) {
      const double distance_m = (end - door.hinge).norm();
      if (distance_m < nearest_m) {
        nearest_m = distance_m;
        brightness = wall.brightness;
      }
    }
  }
  return brightness;
}

}  // namespace

void add_doors(const World& world, Materials& materials, Panels& panels) {
  for (const Door& door : world.doors) {
    const Pose2 T_world_closed{door.hinge.x(), door.hinge.y(), door.closed_heading_rad};
    add_prism(leaf_of(door), materials.wood(door.brightness), panels);
    if (door.frame_width_m > 0) {
      add_frame(door, T_world_closed, materials.paint(door.frame_brightness), panels);
    }
    if (door.wall_depth_m > 0 && world.ceiling_m > door.height_m) {
      add_prism(box(T_world_closed * Pose2{door.width_m / 2, 0, 0}, {door.width_m, door.wall_depth_m},
                    door.height_m, world.ceiling_m),
                materials.plaster(wall_brightness(world, door)), panels);
    }
  }
}

}  // namespace aisle
