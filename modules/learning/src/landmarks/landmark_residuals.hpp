#pragma once
/// The residuals that the adjustment of a run balances, each in standard deviations.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/learning/walls/wall_heading.hpp"
#include "aisle/vehicle/arc.hpp"
#include "aisle/vision/lines/landmark_sightings.hpp"

namespace aisle {

/// Wraps an angle to half a turn around zero.
template <class T>
T wrapped(const T& angle_rad) {
  return angle_rad - 2 * kPi * floor((angle_rad + kPi) / (2 * kPi));
}

/// A residual in standard deviations.
template <class Matrix, class T, std::size_t kSize>
void weigh(const Matrix& root_information, const std::array<T, kSize>& off, T* residual) {
  for (int i = 0; i < static_cast<int>(kSize); ++i) {
    residual[i] = T(0);
    for (int j = 0; j < static_cast<int>(kSize); ++j)
      residual[i] += root_information(i, j) * off[static_cast<std::size_t>(j)];
  }
}

/// The difference (x, y, theta) of b seen from a to its expected value.
template <class T>
std::array<T, 3> relative_pose_error(const T* a, const T* b, const T& x, const T& y, const T& theta) {
  const T c = cos(a[2]), s = sin(a[2]);
  return {c * (b[0] - a[0]) + s * (b[1] - a[1]) - x, -s * (b[0] - a[0]) + c * (b[1] - a[1]) - y,
          wrapped(b[2] - a[2] - theta)};
}

/// The odometry between two keyframes against their poses. Systematic errors are unknowns in standard
/// deviations.
struct OdometryError {
  std::vector<Arc> arcs;
  Vec3 steady_sigmas;
  Mat3 root_information;

  template <class T>
  bool operator()(const T* a, const T* b, const T* steady, T* residual) const {
    T x(0), y(0), theta(0);
    for (const Arc& arc : arcs) {
      const T length = arc.length_m * (1.0 + steady_sigmas[0] * steady[0]);
      const T turn =
          arc.turn_rad * (1.0 + steady_sigmas[1] * steady[1]) + arc.length_m * steady_sigmas[2] * steady[2];
      x += length * cos(theta + turn / 2.0);
      y += length * sin(theta + turn / 2.0);
      theta += turn;
    }
    const auto off = relative_pose_error(a, b, x, y, theta);
    weigh(root_information, off, residual);
    return true;
  }
};

/// A loop, between the keyframes of its two cycles.
struct LoopError {
  static constexpr double kSigma_m = 0.03;
  static constexpr double kSigma_rad = 0.5 * kDegree;

  Pose2 T_a_b;

  template <class T>
  bool operator()(const T* a, const T* b, T* residual) const {
    const auto off = relative_pose_error(a, b, T(T_a_b.x), T(T_a_b.y), T(T_a_b.theta));
    residual[0] = off[0] / kSigma_m;
    residual[1] = off[1] / kSigma_m;
    residual[2] = off[2] / kSigma_rad;
    return true;
  }
};

/// A landmark as seen from a keyframe whose image tilt is an unknown in standard deviations.
struct SightingError {
  Pose2 T_key_vehicle;  ///< pose of the image relative to its keyframe
  LandmarkSighting sighting;
  Mat2 root_information;

  template <class T>
  bool operator()(const T* key, const T* tilt, const T* landmark, T* residual) const {
    const T key_c = cos(key[2]), key_s = sin(key[2]);
    const T x = key[0] + key_c * T_key_vehicle.x - key_s * T_key_vehicle.y;
    const T y = key[1] + key_s * T_key_vehicle.x + key_c * T_key_vehicle.y;
    const T c = cos(key[2] + T_key_vehicle.theta), s = sin(key[2] + T_key_vehicle.theta);
    const std::array<T, 2> off{sighting.p_vehicle.x() - sighting.by_tilt.x() * tilt[0] -
                                   (c * (landmark[0] - x) + s * (landmark[1] - y)),
                               sighting.p_vehicle.y() - sighting.by_tilt.y() * tilt[0] -
                                   (-s * (landmark[0] - x) + c * (landmark[1] - y))};
    weigh(root_information, off, residual);
    return true;
  }
};

/// A landmark against its position known from earlier runs.
struct KnownError {
  Vec2 p_map;
  Mat2 root_information;

  template <class T>
  bool operator()(const T* landmark, T* residual) const {
    const std::array<T, 2> off{landmark[0] - p_map.x(), landmark[1] - p_map.y()};
    weigh(root_information, off, residual);
    return true;
  }
};

/// The heading of a cycle, against walls whose direction is unknown.
struct WallError {
  double key_to_cycle_rad;
  HeadingMeasurement against_walls;

  template <class T>
  bool operator()(const T* key, const T* walls_rad, T* residual) const {
    const T off = key[2] + key_to_cycle_rad - walls_rad[0] - against_walls.heading_rad;
    residual[0] = wrapped(off) / against_walls.sigma_rad;
    return true;
  }
};

/// Keeps unknowns in standard deviations near zero.
template <int kUnknowns>
struct NearZero {
  template <class T>
  bool operator()(const T* values, T* residual) const {
    std::copy_n(values, kUnknowns, residual);
    return true;
  }
};

}  // namespace aisle
