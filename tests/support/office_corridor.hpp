#pragma once
/// A corridor with everything that a camera may see, for tests and benchmarks of the renderer.

#include "aisle/simulation/world.hpp"

namespace aisle {

/// 30 m along x, 2 m wide, y from -1 to 1. A door every 3 m on the left (+y) and, offset by 1 m, on the
/// right.
inline World office_corridor(int doors_per_side = 9) {
  constexpr double kHalfWidth_m = 1, kPitch_m = 3, kWall_m = 0.12, kDoor_m = 0.9, kRoomDepth_m = 4;
  const double length_m = kPitch_m * (doors_per_side + 1);
  World world;
  world.name = "office corridor";
  for (const double side : {1.0, -1.0}) {
    const double y = side * kHalfWidth_m, back = y + side * kWall_m;
    const auto wall = [&](Vec2 from, Vec2 to) {
      if (side > 0) std::swap(from, to);
      world.walls.push_back({.floor_edge = {from, to}});
    };
    double x = 0;
    for (int i = 0; i < doors_per_side; ++i) {
      const double door = kPitch_m * (i + 0.7) + (side < 0 ? 1 : 0);
      wall({x, y}, {door, y});
      wall({door, y}, {door, back});
      wall({door, back}, {x, back});
      wall({door + kDoor_m, back}, {door + kDoor_m, y});
      x = door + kDoor_m;
      world.doors.push_back({.hinge = {door, (y + back) / 2},
                             .open_rad = i % 4 == 2 ? side * 70 * kDegree : 0,
                             .width_m = kDoor_m,
                             .wall_depth_m = kWall_m});
      if (i % 2 == 0) {
        world.posters.push_back({.kind = i % 4 == 0 ? Poster::Kind::kPoster : Poster::Kind::kNoticeBoard,
                                 .centre = {door + kDoor_m + 0.9, y},
                                 .facing_rad = -side * kPi / 2,
                                 .width_m = i % 4 == 0 ? 0.6 : 1.2});
      }
    }
    wall({x, y}, {length_m, y});
    wall({length_m, back}, {x, back});
    wall({0, y + side * kRoomDepth_m}, {length_m, y + side * kRoomDepth_m});
    for (const double end : {0.0, length_m}) {
      world.walls.push_back({.floor_edge = {{end, back}, {end, y + side * kRoomDepth_m}}});
    }
  }
  world.walls.push_back({.floor_edge = {{0, kHalfWidth_m}, {0, -kHalfWidth_m}}});
  world.walls.push_back({.floor_edge = {{length_m, -kHalfWidth_m}, {length_m, kHalfWidth_m}}});
  for (double x = 1.5; x < length_m; x += kPitch_m) {
    world.lamps.push_back({.centre = {x, 0}});
    for (const double y : {-3.0, 3.0}) world.lamps.push_back({.centre = {x, y}, .heading_rad = kPi / 2});
  }
  world.furniture = {{.kind = Furniture::Kind::kBox,
                      .centre = {8.7, 0.75},
                      .size = {0.8, 0.4},
                      .height_m = 1.2,
                      .brightness = 0.4},
                     {.kind = Furniture::Kind::kChair,
                      .centre = {5.2, -0.7},
                      .size = {0.45, 0.45},
                      .heading_rad = kPi / 2,
                      .height_m = 0.9},
                     {.kind = Furniture::Kind::kTable, .centre = {11.5, -0.6}, .size = {1.2, 0.6}},
                     {.kind = Furniture::Kind::kPillar,
                      .centre = {14.5, 0.75},
                      .size = {0.35, 0.35},
                      .height_m = 2.7,
                      .brightness = 0.7}};
  world.papers = {{.centre = {4, 0.2}, .heading_rad = 0.5}};
  world.parking_frames = {{.name = "home", .centre = {2.6, 0}, .size = {1.4, 1.0}}};
  return world;
}

}  // namespace aisle
