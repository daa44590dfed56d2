#include "operators/operator_path.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {
namespace {

constexpr std::array kOperatorClearances_m = {0.1, 0.05, 0.01};
constexpr double kWider = 1.25;  // than the narrowest turn
constexpr double kArcStep_rad = 10 * kDegree;
constexpr double kEarlierStep_m = 0.05;
constexpr int kEarlierSteps = 8;
constexpr double kBackOnRoute_m = 1.2;  // beyond the corner, after turning in early

double turn_at(const Vec2& before, const Vec2& corner, const Vec2& after) {
  return turn_between(corner - before, after - corner);
}

/// Poses on the arc that begins `tangent_m + earlier_m` before the corner.
std::vector<Pose2> arc_round(const Vec2& before, const Vec2& corner, double turn_rad, double tangent_m,
                             double earlier_m) {
  const Vec2 ahead = (corner - before).normalized();
  const Vec2 begin = corner - (tangent_m + earlier_m) * ahead;
  const Pose2 T_world_begin{begin.x(), begin.y(), heading_of(ahead)};
  const double arc_m = tangent_m / std::tan(std::abs(turn_rad) / 2) * std::abs(turn_rad);
  const int steps = static_cast<int>(std::ceil(std::abs(turn_rad) / kArcStep_rad));
  std::vector<Pose2> poses;
  for (int k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    poses.push_back(T_world_begin * end_pose({share * arc_m, share * turn_rad}));
  }
  return poses;
}

}  // namespace

Footprint with_clearance(Footprint footprint, double clearance_m) {
  footprint.front_m += clearance_m;
  footprint.rear_m += clearance_m;
  footprint.width_m += 2 * clearance_m;
  return footprint;
}

double turning_radius_m(const VehicleDescription& vehicle) {
  return kWider * vehicle.front_steered.wheelbase_m / std::tan(vehicle.limits.steering_max_rad);
}

OperatorPath::OperatorPath(const World& world, const VehicleDescription& vehicle)
    : vehicle_(vehicle),
      obstacles_{Obstacles(world, with_clearance(vehicle.footprint, kOperatorClearances_m[0])),
                 Obstacles(world, with_clearance(vehicle.footprint, kOperatorClearances_m[1])),
                 Obstacles(world, with_clearance(vehicle.footprint, kOperatorClearances_m[2]))} {}

std::vector<Vec2> OperatorPath::drivable(const std::vector<Vec2>& points, bool in_reverse) {
  if (vehicle_.is_differential) return points;
  std::vector<Vec2> smooth = {points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (std::abs(turn_at(points[i - 1], points[i], points[i + 1])) < kArcStep_rad / 2) {
      smooth.push_back(points[i]);
      continue;
    }
    for (const Pose2& T : round(points[i - 1], points[i], points[i + 1], in_reverse))
      smooth.push_back(T.position());
  }
  smooth.push_back(points.back());
  smooth.erase(std::unique(smooth.begin(), smooth.end()), smooth.end());
  return smooth;
}

/// With as much clearance as there is, turning in as late as that allows.
std::vector<Pose2> OperatorPath::round(const Vec2& before, const Vec2& corner, const Vec2& after,
                                       bool in_reverse) {
  const double turn_rad = turn_at(before, corner, after);
  const double in_m = (corner - before).norm(), out_m = (after - corner).norm();
  const double tangent_m =
      std::min({turning_radius_m(vehicle_) * std::tan(std::abs(turn_rad) / 2), in_m / 2, out_m / 2});
  const double back_m = tangent_m + kBackOnRoute_m;
  for (Obstacles& obstacles : obstacles_) {
    for (int step = 0; step <= kEarlierSteps; ++step) {
      const double earlier_m = step * kEarlierStep_m;
      if (earlier_m > 0 && (tangent_m + earlier_m > in_m / 2 || back_m > out_m / 2)) break;
      std::vector<Pose2> path = arc_round(before, corner, turn_rad, tangent_m, earlier_m);
      if (!is_free(path, in_reverse, obstacles)) continue;
      if (earlier_m == 0) return path;
      const Vec2 back = corner + back_m / out_m * (after - corner);
      path.push_back({back.x(), back.y(), path.back().theta});
      if (is_free(path, in_reverse, obstacles)) return path;
    }
  }
  return arc_round(before, corner, turn_rad, tangent_m, 0);
}

bool OperatorPath::is_free(const std::vector<Pose2>& path, bool in_reverse, Obstacles& obstacles) const {
  return std::none_of(path.begin(), path.end(), [&](Pose2 T_world_path) {
    if (in_reverse) T_world_path.theta = wrap_angle(T_world_path.theta + kPi);
    return obstacles.touch(T_world_path);
  });
}

}  // namespace aisle
