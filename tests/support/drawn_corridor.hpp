#pragma once
/// Images drawn from geometry, so that the positions of their edges are known exactly.

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The image of a brightness function over the image plane, each pixel the mean over its area.
template <class Brightness>
Image drawn(int width_px, int height_px, int samples, const Brightness& brightness) {
  Image image(width_px, height_px);
  for (int v = 0; v < height_px; ++v) {
    for (int u = 0; u < width_px; ++u) {
      double sum = 0;
      for (int i = 0; i < samples * samples; ++i) {
        const double du = (i % samples + 0.5) / samples - 0.5;
        const double dv = static_cast<double>(i / samples) / samples + 0.5 / samples - 0.5;
        sum += brightness(Vec2(u + du, v + dv));
      }
      image.row(v)[u] =
          static_cast<std::uint8_t>(std::clamp(std::lround(sum / (samples * samples)), 0L, 255L));
    }
  }
  return image;
}

inline Image mirrored(const Image& image) {
  Image out = image;
  for (int v = 0; v < image.height_px; ++v) std::reverse(out.row(v), out.row(v) + image.width_px);
  return out;
}

/// A straight corridor with doors in both walls, seen by a camera in it. Metres, in the camera's frame: x
/// right, y down, z along the corridor.
struct DrawnCorridor {
  double height_m = 1;  ///< of the camera
  double left_m = -1.1, right_m = 0.9, end_m = 14, ceiling_m = -1.6;
  double skirting_m = 0.1;
  double shine = 0;                   ///< share of the reflection in the brightness of the floor
  double down_rad = 0, roll_rad = 0;  ///< orientation of the camera
  double first_door_m = 3, door_m = 0.9, door_step_m = 2.6;
  int width_px = 640, height_px = 480;
  CameraIntrinsics camera{500, 500, 319.5, 239.5};

  /// The image point of a point of the corridor.
  Vec2 pixel(const Vec3& p_corridor) const {
    return CameraModel(camera).project(turn().transpose() * p_corridor).value();
  }
  std::vector<Vec2> base_line(double x_m) const {
    std::vector<Vec2> line;
    for (double z_m = 2.2; z_m <= 8; z_m += 0.2) line.push_back(pixel({x_m, height_m, z_m}));
    return line;
  }
  Image image(int samples = 3) const {
    const CameraModel model(camera);
    const bool straight = camera.k1 == 0;
    return drawn(width_px, height_px, samples, [&](const Vec2& p) {
      const Vec3 direction =
          straight ? Vec3((p.x() - camera.cx_px) / camera.fx_px, (p.y() - camera.cy_px) / camera.fy_px, 1)
                   : model.ray(p)->direction;
      return brightness(Vec3::Zero(), turn() * direction, true);
    });
  }

 private:
  Mat3 turn() const {
    const double cd = std::cos(down_rad), sd = std::sin(down_rad), cr = std::cos(roll_rad),
                 sr = std::sin(roll_rad);
    Mat3 down, roll;
    down << 1, 0, 0, 0, cd, sd, 0, -sd, cd;
    roll << cr, -sr, 0, sr, cr, 0, 0, 0, 1;
    return down * roll;
  }

  double brightness(const Vec3& from, const Vec3& direction, bool reflects) const {
    const auto reach = [&](int axis, double low, double high) {
      const double d = direction[axis];
      return std::abs(d) < 1e-12 ? 1e9 : ((d > 0 ? high : low) - from[axis]) / d;
    };
    const double x = reach(0, left_m, right_m), y = reach(1, ceiling_m, height_m), z = reach(2, -20, end_m);
    const double nearest = std::min({x, y, z});
    const Vec3 at = from + nearest * direction;
    if (nearest == y) {
      if (direction.y() < 0) return 225;
      if (!reflects || shine == 0) return 125;
      return (1 - shine) * 125 +
             shine * brightness(at, Vec3(direction.x(), -direction.y(), direction.z()), false);
    }
    if (nearest == z) return height_m - at.y() < skirting_m ? 50 : 160;
    const double into_m = std::fmod(at.z() - first_door_m + 100 * door_step_m, door_step_m);
    if (into_m < door_m && height_m - at.y() < 2.05) return 70;
    if (height_m - at.y() < skirting_m) return 45;
    return direction.x() > 0 ? 195 : 205;
  }
};

}  // namespace aisle
