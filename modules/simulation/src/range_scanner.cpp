#include "aisle/simulation/range_scanner.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/simulation/slice.hpp"

namespace aisle {

RangeScanner::RangeScanner(const World& world, const RangeScannerParams& params)
    : params_(params), walls_(slice(world, params.height_m)) {}

LaserScanner RangeScanner::description() const {
  return {.first_angle_rad = params_.first_angle_rad,
          .angle_step_rad = params_.angle_step_rad,
          .range_max_m = params_.range_max_m,
          .T_vehicle_laser = {params_.mount_x_m, params_.mount_y_m, params_.mount_heading_rad}};
}

std::vector<float> RangeScanner::scan(const Pose2& T_world_vehicle, Random& random) const {
  const LaserScanner laser = description();
  const Pose2 T_world_laser = T_world_vehicle * laser.T_vehicle_laser;
  std::vector<float> ranges_m(static_cast<std::size_t>(params_.beams));
  for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
    const Vec2 direction = unit(T_world_laser.theta + laser.beam_angle(beam) + params_.angle_offset_rad);
    ranges_m[beam] = static_cast<float>(reading_m(walls_.cast(T_world_laser.position(), direction), random));
  }
  return ranges_m;
}

/// Draws the same count of random numbers for every beam, so that a fault of one beam leaves the others
/// alone.
double RangeScanner::reading_m(double true_m, Random& random) const {
  const double noise_m = random.normal(params_.noise_sigma_m);
  const bool is_dropped = random.uniform() < params_.dropped_share;
  double range_m = true_m + noise_m;
  if (is_dropped || !(range_m < params_.range_max_m)) return params_.range_max_m;
  if (params_.resolution_m > 0) range_m = params_.resolution_m * std::round(range_m / params_.resolution_m);
  return std::clamp(range_m, params_.resolution_m, params_.range_max_m);
}

}  // namespace aisle
