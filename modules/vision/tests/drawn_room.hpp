#pragma once
/// Images of rooms whose geometry is known exactly, for the detectors that know how the camera is mounted.

#include <algorithm>
#include <cmath>
#include <list>
#include <utility>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/image.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/segment2.hpp"

namespace aisle {

struct DrawnWall {
  Segment2 floor_edge;  ///< where it meets the floor, in base_link
  double brightness = 170;
  double skirting_brightness = 60;
  double skirting_height_m = 0.1;
  double laser_height_m = 0;  ///< of a bright line, 1 cm thick; 0: none
};

/// Something upright and flat on a wall: from and to along it [m], between two heights.
struct DrawnPanel {
  std::size_t wall = 0;
  double from_m = 0, to_m = 1;
  double bottom_m = 0, top_m = 2;
  double brightness = 100;
};

inline CameraIntrinsics drawn_lens() {
  return {.fx_px = 460, .fy_px = 460, .cx_px = 319.5, .cy_px = 239.5, .k1 = -0.18, .k2 = 0.03};
}

/// 113 degrees from side to side.
inline CameraIntrinsics drawn_fisheye() {
  return {.fx_px = 320,
          .fy_px = 320,
          .cx_px = 319.5,
          .cy_px = 239.5,
          .k1 = -0.02,
          .k2 = 0.004,
          .model = LensModel::kEquidistant};
}

struct DrawnRoom {
  double floor_brightness = 140;
  double tile_m = 0;  ///< 0: none
  double joint_m = 0.005, joint_brightness = 100;
  double shadow_m = 0;  ///< before walls, in which it fades; 0: none
  std::vector<DrawnWall> walls;
  std::vector<DrawnPanel> panels;
  std::vector<Segment2> papers;  ///< a sheet 0.2 m wide around each, on the floor
  std::vector<Segment2> worn;    ///< the same where the floor is a little brighter
  CameraIntrinsics lens = drawn_lens();
};

inline CameraMount drawn_mount() {
  return {.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};
}

class RoomDrawing {
 public:
  RoomDrawing(const DrawnRoom& room, const CameraMount& mount)
      : room_(room), mount_(mount), R_vehicle_camera_(mount.R_vehicle_camera()), rays_(rays_of(room.lens)) {}

  Image image() const {
    Image image(640, 480);
    for (int v = 0; v < image.height_px; ++v)
      for (int u = 0; u < image.width_px; ++u) image.row(v)[u] = pixel(u, v);
    return image;
  }

 private:
  std::uint8_t pixel(int u, int v) const {
    const PixelRay& ray = rays_[static_cast<std::size_t>(v * 640 + u)];
    double sum = 0;
    for (int i = 0; i < 9; ++i) {
      const Vec2 off = ray.by_pixel * Vec2((i % 3 - 1) / 3.0, (i / 3 - 1) / 3.0);
      sum += brightness(R_vehicle_camera_ * (ray.direction + Vec3(off.x(), off.y(), 0)));
    }
    return static_cast<std::uint8_t>(std::lround(sum / 9));
  }

  static const std::vector<PixelRay>& rays_of(const CameraIntrinsics& lens) {
    static std::list<std::pair<CameraIntrinsics, std::vector<PixelRay>>> known;
    for (const auto& [known_lens, rays] : known)
      if (known_lens == lens) return rays;
    const CameraModel camera(lens);
    std::vector<PixelRay>& rays = known.emplace_back(lens, std::vector<PixelRay>()).second;
    for (int v = 0; v < 480; ++v)
      for (int u = 0; u < 640; ++u) rays.push_back(camera.ray(Vec2(u, v)).value_or(PixelRay{}));
    return rays;
  }

  double brightness(const Vec3& ray) const {
    const Vec3& eye = mount_.p_vehicle_camera;
    double nearest = ray.z() < 0 ? -eye.z() / ray.z() : 1e9;
    double seen = ray.z() < 0 ? on_floor((eye + nearest * ray).head<2>()) : 200;
    for (std::size_t i = 0; i < room_.walls.size(); ++i) {
      const Segment2& floor_edge = room_.walls[i].floor_edge;
      const Vec2 along = floor_edge.end - floor_edge.start, across = left_normal(along),
                 from = floor_edge.start - eye.head<2>();
      const double share = across.dot(from) / across.dot(ray.head<2>());
      const Vec3 p = eye + share * ray;
      const double on_wall = along.dot(p.head<2>() - floor_edge.start) / along.norm();
      if (!(share > 0 && share < nearest && on_wall >= 0 && on_wall <= along.norm() && p.z() < 2.7)) continue;
      nearest = share;
      seen = on_its_wall(i, on_wall, p.z());
    }
    return seen;
  }

  double on_floor(const Vec2& p) const {
    for (const Segment2& paper : room_.papers)
      if (paper.distance(p) < 0.1) return 240;
    for (const Segment2& worn : room_.worn)
      if (worn.distance(p) < 0.1) return room_.floor_brightness + 25;
    const auto joint = [&](double x) {
      return std::abs(std::remainder(x, room_.tile_m)) < room_.joint_m / 2;
    };
    const bool is_joint = room_.tile_m > 0 && (joint(p.x()) || joint(p.y()));
    return lit(p) * (is_joint ? room_.joint_brightness : room_.floor_brightness);
  }

  double lit(const Vec2& p) const {
    double share = 1;
    if (room_.shadow_m > 0)
      for (const DrawnWall& wall : room_.walls)
        share -= 0.25 * std::exp(-wall.floor_edge.distance(p) / room_.shadow_m);
    return share;
  }

  double on_its_wall(std::size_t wall, double along_m, double height_m) const {
    for (const DrawnPanel& panel : room_.panels) {
      if (panel.wall == wall && along_m >= panel.from_m && along_m <= panel.to_m &&
          height_m >= panel.bottom_m && height_m <= panel.top_m)
        return panel.brightness;
    }
    const DrawnWall& seen = room_.walls[wall];
    if (std::abs(height_m - seen.laser_height_m) < 0.005 && seen.laser_height_m > 0) return 250;
    return height_m < seen.skirting_height_m ? seen.skirting_brightness : seen.brightness;
  }

  DrawnRoom room_;
  CameraMount mount_;
  Mat3 R_vehicle_camera_;
  const std::vector<PixelRay>& rays_;
};

inline Image drawn(const DrawnRoom& room, const CameraMount& mount = drawn_mount()) {
  return RoomDrawing(room, mount).image();
}

/// A wall at a distance from the floor point beneath the camera. Its normal is turned by `heading_rad` from
/// straight ahead; the camera is on its left.
inline DrawnWall wall_ahead(double distance_m, double heading_rad) {
  const Vec2 out = unit(heading_rad), middle = drawn_mount().p_vehicle_camera.head<2>() + distance_m * out;
  return {.floor_edge = {middle - 20 * left_normal(out), middle + 20 * left_normal(out)}};
}

}  // namespace aisle
