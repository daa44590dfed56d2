/// Vertical lines and base lines in images of the simulated camera in a corridor with niches and doors,
/// compared with the projected corners of the walls and edges of the door frames.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "aisle/vision/floor/line_finder.hpp"

namespace aisle {
namespace {

constexpr double kHalfWidth_m = 1.1;
constexpr double kNicheDepth_m = 0.5;
constexpr double kCorridor_m = 14;

struct Niche {
  double from_m, to_m;
};
constexpr Niche kRightNiches[] = {{3.2, 4.3}, {7.0, 8.4}};
constexpr Niche kLeftNiches[] = {{4.0, 5.2}, {8.2, 9.4}};
constexpr double kRightHinge_m = 5.2, kLeftHinge_m = 7.2;  // x at which the doors begin and end

void add_wall(World& world, const std::vector<Vec2>& points) {
  for (std::size_t i = 1; i < points.size(); ++i)
    world.walls.push_back({.floor_edge = {points[i - 1], points[i]}});
}

/// From x = 0 to 14 m, free side to the left of each face.
World corridor() {
  World world;
  world.skirting_height_m = 0;  // a board would stand a little ahead of the corner
  std::vector<Vec2> right{{0, -kHalfWidth_m}}, left{{0, kHalfWidth_m}};
  const auto add_niches = [](std::vector<Vec2>& points, const auto& niches, double side) {
    for (const Niche& niche : niches) {
      for (const auto& [x, depth] : {std::pair{niche.from_m, 0.0}, std::pair{niche.from_m, kNicheDepth_m},
                                     std::pair{niche.to_m, kNicheDepth_m}, std::pair{niche.to_m, 0.0}})
        points.emplace_back(x, side * (kHalfWidth_m + depth));
    }
    points.emplace_back(kCorridor_m, side * kHalfWidth_m);
  };
  add_niches(right, kRightNiches, -1);
  add_niches(left, kLeftNiches, 1);
  std::reverse(left.begin(), left.end());
  add_wall(world, right);
  add_wall(world, {right.back(), left.front()});
  add_wall(world, left);
  add_wall(world, {left.back(), right.front()});
  world.doors = {{.hinge = {kRightHinge_m, -kHalfWidth_m}},
                 {.hinge = {kLeftHinge_m, kHalfWidth_m}, .closed_heading_rad = kPi}};
  for (double x = 1.4; x < kCorridor_m; x += 2.8) world.lamps.push_back({.centre = {x, 0}});
  return world;
}

CameraDescription camera() {
  CameraDescription camera;
  camera.intrinsics = {460, 460, 319.5, 239.5, 0, 0, 0, 0, 0};
  camera.mount = {{0, 0, 1.0}, 8 * kDegree, 0, 0};
  return camera;
}

/// A true vertical line of the building, projected into the image.
struct TrueLine {
  Vec2 floor_point_px = Vec2::Zero();
  Vec2 middle_px = Vec2::Zero();
  bool is_corner = false;  ///< of the walls themselves, whose floor point is exact
};

std::vector<TrueLine> true_lines(const Pose2& T_world_vehicle) {
  const CameraDescription seen_by = camera();
  const CameraModel lens(seen_by.intrinsics);
  const auto pixel = [&](double x, double y, double z) {
    const Vec2 p_vehicle = T_world_vehicle.inverse() * Vec2(x, y);
    return lens.project(seen_by.mount.to_camera({p_vehicle.x(), p_vehicle.y(), z}));
  };
  std::vector<TrueLine> lines;
  const auto add = [&](double x, double side, bool is_corner) {
    const auto floor_point = pixel(x, side * kHalfWidth_m, 0), middle = pixel(x, side * kHalfWidth_m, 1);
    if (!floor_point || !middle) return;
    const bool is_seen = floor_point->x() > 8 && floor_point->x() < 631 && floor_point->y() < 470;
    const bool is_near =
        (Vec2(x, side * kHalfWidth_m) - Vec2(T_world_vehicle.x, T_world_vehicle.y)).norm() < 7;
    if (is_seen && is_near) lines.push_back({*floor_point, *middle, is_corner});
  };
  for (const Niche& niche : kRightNiches)
    for (const double x : {niche.from_m, niche.to_m}) add(x, -1, true);
  for (const Niche& niche : kLeftNiches)
    for (const double x : {niche.from_m, niche.to_m}) add(x, 1, true);
  const Door door;
  for (const double x :
       {kRightHinge_m - door.frame_width_m, kRightHinge_m + door.width_m + door.frame_width_m})
    add(x, -1, false);
  for (const double x : {kLeftHinge_m + door.frame_width_m, kLeftHinge_m - door.width_m - door.frame_width_m})
    add(x, 1, false);
  return lines;
}

double u_at(const VerticalLine& line, double v_px) {
  const Vec2 down = line.bottom_px - line.top_px;
  return line.top_px.x() + down.x() / down.y() * (v_px - line.top_px.y());
}

std::vector<VerticalLine> found_lines(const Pose2& T_world_vehicle) {
  static const RenderedWorld world(corridor());
  CameraMoment moment;
  moment.T_world_vehicle = T_world_vehicle;
  const Image grey = CameraSensor(camera(), {}, 1).take(world, moment);
  return LineFinder().find(grey).verticals;
}

TEST(RenderedLines, NineInTenCornersAndFramesAreFoundAndCornersStandWithinFivePixels) {
  int known = 0, found = 0;
  std::vector<double> floor_points_off_px;
  for (const Pose2& T_world_vehicle :
       {Pose2{0.8, 0, 0}, Pose2{1.5, 0.2, 3 * kDegree}, Pose2{2.2, -0.2, -4 * kDegree}, Pose2{3, 0.1, 0}}) {
    const auto lines = found_lines(T_world_vehicle);
    for (const TrueLine& truth : true_lines(T_world_vehicle)) {
      ++known;
      const auto line = std::find_if(lines.begin(), lines.end(), [&](const VerticalLine& candidate) {
        return std::abs(u_at(candidate, truth.middle_px.y()) - truth.middle_px.x()) < 3 &&
               candidate.top_px.y() < truth.middle_px.y() && candidate.bottom_px.y() > truth.middle_px.y();
      });
      if (line == lines.end()) continue;
      ++found;
      if (truth.is_corner && line->has_floor_point)
        floor_points_off_px.push_back((line->bottom_px - truth.floor_point_px).norm());
    }
  }
  ASSERT_GE(known, 20);
  EXPECT_GE(found, 0.9 * known) << found << " of " << known;
  ASSERT_GE(floor_points_off_px.size(), 8U);
  std::sort(floor_points_off_px.begin(), floor_points_off_px.end());
  EXPECT_LT(floor_points_off_px[floor_points_off_px.size() / 2], 5)
      << "median of " << floor_points_off_px.size();
}

}  // namespace
}  // namespace aisle
