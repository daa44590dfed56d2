#include "aisle/guidance/swept_strip.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kStep_m = 0.05;

bool is_within(const Footprint& footprint, double margin_m, const Vec2& p_vehicle) {
  return p_vehicle.x() <= footprint.front_m && p_vehicle.x() >= -footprint.rear_m &&
         std::abs(p_vehicle.y()) <= footprint.width_m / 2 + margin_m;
}

}  // namespace

double SweptStrip::free_m(std::span<const Vec2> p_vehicle, double reach_m) const {
  double free = reach_m;
  for (double way_m = 0; way_m < free; way_m += kStep_m) {
    const Pose2 T_there_vehicle = end_pose({way_m, way_m * turn_rad_per_m}).inverse();
    const double c = std::cos(T_there_vehicle.theta), s = std::sin(T_there_vehicle.theta);
    for (const Vec2& p : p_vehicle) {
      const Vec2 p_there(c * p.x() - s * p.y() + T_there_vehicle.x,
                         s * p.x() + c * p.y() + T_there_vehicle.y);
      if (is_within(footprint, margin_m, p_there)) {
        // On the way since the step before, the front has come at most that far past the point.
        free = std::max(0.0, way_m - std::min(kStep_m, footprint.front_m - p_there.x()));
        break;
      }
    }
  }
  return free;
}

double curvature_of(const VehicleDescription& vehicle, const Command& command) {
  if (!vehicle.is_differential) return std::tan(command.steering_rad) / vehicle.front_steered.wheelbase_m;
  if (command.speed_mps == 0) return 0;
  return command.turn_rate_rad_s / std::abs(command.speed_mps);
}

}  // namespace aisle
