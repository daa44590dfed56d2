#pragma once
/// Simulated floor points of vertical lines along a corridor: door frames and other objects on two walls, and
/// the view of a vehicle in the middle, with missing points, clutter, and noise that grows with the distance.

#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/matching/mwght.hpp"

namespace aisle {

struct CorridorPoints {
  std::vector<WeightedPoint> learned;  ///< relative to the vehicle's assumed pose
  std::vector<WeightedPoint> seen;
  Pose2 truth;  ///< truth * seen coincides with learned
};

struct CorridorSight {
  int learned = 60;
  int seen = 30;
  double clutter = 0.3;   ///< share of the seen points that nobody learned
  double noise_m = 0.02;  ///< of a coordinate, near the vehicle
  double noise_per_m = 0.004;
  Pose2 off;  ///< limits of the pose error, each within +-
};

/// Points on both walls from 1 m behind the vehicle onwards, at random increasing distances.
inline std::vector<WeightedPoint> corridor_walls(int count, Random& random) {
  std::vector<WeightedPoint> points;
  double along_m[2] = {-1, -0.6};
  while (static_cast<int>(points.size()) < count) {
    const int side = along_m[0] < along_m[1] ? 0 : 1;
    const double y = side == 0 ? 1.1 : -1.1;
    const double width_m = random.uniform() < 0.6 ? 0.9 : random.uniform(0.2, 1.5);  // a door or a print
    for (const double x : {along_m[side], along_m[side] + width_m})
      points.push_back({{x, y + random.normal(0.01)}, random.uniform(0.4, 2.0)});
    along_m[side] += width_m + random.uniform(0.15, 1.0);
  }
  points.resize(static_cast<std::size_t>(count));
  return points;
}

inline CorridorPoints corridor_points(const CorridorSight& sight, Random& random) {
  CorridorPoints points;
  points.learned = corridor_walls(sight.learned, random);
  points.truth = {random.uniform(-sight.off.x, sight.off.x), random.uniform(-sight.off.y, sight.off.y),
                  random.uniform(-sight.off.theta, sight.off.theta)};
  const Pose2 T_seen_learned = points.truth.inverse();
  const auto see = [&](const Vec2& place) {
    const double noise_m = sight.noise_m + sight.noise_per_m * place.norm();
    points.seen.push_back(
        {place + Vec2(random.normal(noise_m), random.normal(noise_m)), 1 / (1 + place.norm() / 10)});
  };
  std::vector<WeightedPoint> ahead;
  for (const WeightedPoint& p : points.learned) {
    if (p.position.x() > 1 && p.position.x() < 9) ahead.push_back(p);
  }
  const int clutter = static_cast<int>(sight.clutter * sight.seen);
  while (static_cast<int>(points.seen.size()) < sight.seen - clutter && !ahead.empty()) {
    const auto i = static_cast<std::ptrdiff_t>(random.index(ahead.size()));
    see(T_seen_learned * ahead[static_cast<std::size_t>(i)].position);
    ahead.erase(ahead.begin() + i);
  }
  for (int i = 0; i < clutter; ++i) see({random.uniform(1, 9), random.uniform(-1.2, 1.2)});
  return points;
}

}  // namespace aisle
