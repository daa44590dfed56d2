#pragma once
/// Simulated runs along a straight corridor for learning landmarks: the floor points of vertical lines on its
/// two walls, the view of a vehicle that drives along its middle, and its odometry.

#include <cmath>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/core/square.hpp"
#include "aisle/learning/landmarks/landmark_learning.hpp"

namespace aisle {

/// The floor point of a vertical line.
struct CorridorLine {
  Vec2 p_map = Vec2::Zero();
  bool brighter_right = false;
};

inline VehicleDescription corridor_cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  vehicle.front_steered_noise = {.distance_scale = 0.01,
                                 .distance_slip_m_per_sqrt_m = 0.003,
                                 .heading_slip_rad_per_sqrt_m = 0.2 * kDegree,
                                 .distance_quantum_m = 0.001,
                                 .steering_bias_rad = 0.5 * kDegree,
                                 .steering_quantum_rad = 0};
  return vehicle;
}

/// Lines on both walls, 0.35 to 1.2 m apart on each wall.
inline std::vector<CorridorLine> corridor_lines(double length_m, Random& random) {
  std::vector<CorridorLine> lines;
  for (const double y : {1.1, -1.1}) {
    for (double x = random.uniform(0.5, 1); x < length_m; x += random.uniform(0.35, 1.2))
      lines.push_back({{x, y}, random.uniform() < 0.5});
  }
  return lines;
}

struct SightNoise {
  double away_m = 0.015;     ///< along the line of sight, at 1 m; grows with the square of the distance
  double lateral_m = 0.004;  ///< across it, at 1 m; grows with the distance
  double tilt_m =
      0.01;  ///< a floor point's error at 3 m due to the image's tilt error, along the line of sight
  double unseen = 0.2;  ///< share of the lines missing in an image
  double clutter = 0;   ///< wrong floor points per image, on average below one
  int grain = 0;        ///< further wrong floor points, in every image
};

inline constexpr double kSightMin_m = 1, kSightMax_m = 5;

inline LandmarkSighting sighting_of(const Vec2& p_vehicle, bool brighter_right, const SightNoise& noise) {
  const double distance_m = p_vehicle.norm();
  const Vec2 away = p_vehicle / distance_m;
  const double away_m = noise.away_m * square(distance_m / 2), lateral_m = noise.lateral_m * distance_m;
  const Vec2 by_tilt = noise.tilt_m * square(distance_m / 3) * away;
  return {.p_vehicle = p_vehicle,
          .covariance = square(away_m) * away * away.transpose() +
                        square(lateral_m) * left_normal(away) * left_normal(away).transpose() +
                        by_tilt * by_tilt.transpose(),
          .by_tilt = by_tilt,
          .brighter_right = brighter_right};
}

/// The view in one image. Without `random`: everything, exactly where it is.
inline std::vector<LandmarkSighting> sightings_from(const std::vector<CorridorLine>& lines,
                                                    const Pose2& T_map_vehicle, const SightNoise& noise,
                                                    Random* random = nullptr) {
  std::vector<LandmarkSighting> sightings;
  const double tilt = random == nullptr ? 0 : random->normal();
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  for (const CorridorLine& line : lines) {
    const Vec2 p_vehicle = T_vehicle_map * line.p_map;
    if (p_vehicle.x() < kSightMin_m || p_vehicle.x() > kSightMax_m) continue;
    LandmarkSighting sighting = sighting_of(p_vehicle, line.brighter_right, noise);
    if (random != nullptr) {
      if (random->uniform() < noise.unseen) continue;
      const Vec2 away = p_vehicle.normalized();
      sighting.p_vehicle += random->normal(noise.away_m * square(p_vehicle.norm() / 2)) * away +
                            random->normal(noise.lateral_m * p_vehicle.norm()) * left_normal(away) +
                            tilt * sighting.by_tilt;
    }
    sightings.push_back(sighting);
  }
  const int wrong = random == nullptr ? 0 : noise.grain + (random->uniform() < noise.clutter ? 1 : 0);
  for (int i = 0; i < wrong; ++i) {
    const Vec2 p_vehicle{random->uniform(kSightMin_m, kSightMax_m), random->uniform(-1, 1)};
    sightings.push_back(sighting_of(p_vehicle, random->uniform() < 0.5, noise));
  }
  return sightings;
}

struct CorridorRun {
  std::vector<LandmarkCycle> cycles;
  std::vector<Pose2> T_map_vehicle;  ///< the truth
};

/// Straight on from a start, with an image every 8 cm.
inline CorridorRun corridor_run(const std::vector<CorridorLine>& lines, double path_m,
                                const SightNoise& noise, Random& random, Pose2 T_map_vehicle = {}) {
  constexpr double kStep_m = 0.08;
  const FrontSteeredNoise odometry = corridor_cart().front_steered_noise;
  const double scale = 1 + random.normal(odometry.distance_scale);
  const double turn_per_m =
      random.normal(odometry.steering_bias_rad / corridor_cart().front_steered.wheelbase_m);
  CorridorRun run;
  const int steps = static_cast<int>(path_m / kStep_m);
  for (int i = 0; i <= steps; ++i) {
    LandmarkCycle cycle{.stamp_s = 0.2 * i, .odometry = FrontSteeredMotion{}, .sightings = {}};
    if (i > 0) {
      const double wanted_rad =
          -0.4 * T_map_vehicle.theta - 0.1 * T_map_vehicle.y * kStep_m;  // back to the middle
      const double steering_rad = std::atan(0.75 * (wanted_rad / kStep_m - turn_per_m));
      cycle.odometry = FrontSteeredMotion{kStep_m, steering_rad};
      const Arc reported = arc_of(corridor_cart().front_steered, FrontSteeredMotion{kStep_m, steering_rad});
      T_map_vehicle =
          T_map_vehicle *
          end_pose({reported.length_m * scale +
                        random.normal(odometry.distance_slip_m_per_sqrt_m * std::sqrt(kStep_m)),
                    reported.turn_rad + turn_per_m * kStep_m +
                        random.normal(odometry.heading_slip_rad_per_sqrt_m * std::sqrt(kStep_m))});
    }
    cycle.sightings = sightings_from(lines, T_map_vehicle, noise, &random);
    run.cycles.push_back(std::move(cycle));
    run.T_map_vehicle.push_back(T_map_vehicle);
  }
  return run;
}

/// The lines as a map that knows them all exactly, from driving in the direction of x.
inline LandmarkMap map_of(const std::vector<CorridorLine>& lines) {
  LandmarkMap map;
  for (const CorridorLine& line : lines) {
    Landmark landmark;
    landmark.p_map = line.p_map;
    landmark.mass = 1;
    landmark.sightings = 10;
    landmark.passes = 1;
    landmark.seen_from = Vec2(-3, -line.p_map.y()).normalized();
    landmark.brighter_right = line.brighter_right;
    map.add(landmark);
  }
  return map;
}

}  // namespace aisle
