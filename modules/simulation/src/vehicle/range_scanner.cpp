#include "aisle/simulation/vehicle/range_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace aisle {

void RangeSensorParams::describe(FieldList& fields) {
  fields.count("beams", beams, {1, 4096}, "readings in a scan");
  fields.real("noise_sigma_m", noise_sigma_m, {0, 1}, "standard deviation of a reading");
  fields.angle("angle_offset_deg", angle_offset_rad, {-10, 10},
               "how much farther left than the logged angles it really looks");
  fields.real("resolution_m", resolution_m, {0, 0.5}, "readings are whole multiples of this; 0: not rounded");
  fields.real("dropped_share", dropped_share, {0, 1}, "share of readings that miss the wall, as on glass");
  fields.real("height_m", height_m, {0, 3}, "scanner above the floor");
}

RangeScanner::RangeScanner(const World& world, const RangeScannerParams& params)
    : RangeScanner(params, seen_outlines(world, params.sensor.height_m)) {}

RangeScanner::RangeScanner(const RangeScannerParams& params, SeenOutlines outlines)
    : params_(params), walls_(std::move(outlines.clear)), faint_(std::move(outlines.faint)) {}

std::vector<float> RangeScanner::scan(const Pose2& T_world_vehicle, Random& random,
                                      std::span<const Segment2> movers) const {
  const Pose2 T_world_laser = T_world_vehicle * params_.laser.T_vehicle_laser;
  std::vector<float> ranges_m(static_cast<std::size_t>(params_.sensor.beams));
  for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
    const Vec2 direction =
        unit(T_world_laser.theta + params_.laser.beam_angle(beam) + params_.sensor.angle_offset_rad);
    double true_m = seen_m(T_world_laser.position(), direction, random);
    for (const Segment2& edge : movers) {
      true_m = std::min(true_m, ray_distance(T_world_laser.position(), direction, edge));
    }
    ranges_m[beam] = static_cast<float>(reading_m(true_m, random));
  }
  return ranges_m;
}

/// To what sends the beam back; infinity: nothing does. Whether a faint outline does is chance, once a beam
/// for each, so that the beams of a world without any are as they were.
double RangeScanner::seen_m(const Vec2& p_world_laser, const Vec2& direction, Random& random) const {
  double nearest_m = walls_.cast(p_world_laser, direction);
  bool is_lost = false;
  for (const FaintOutline& outline : faint_) {
    const double there_m = ray_distance(p_world_laser, direction, outline.segment);
    const bool returns = random.uniform() < outline.returns;
    if (there_m >= nearest_m || (outline.is_glass && !returns)) continue;
    nearest_m = there_m;
    is_lost = !returns;
  }
  return is_lost ? std::numeric_limits<double>::infinity() : nearest_m;
}

/// Draws the same number of random numbers for every beam, so that a fault of one beam does not change the
/// others.
double RangeScanner::reading_m(double true_m, Random& random) const {
  const double range_max_m = params_.laser.range_max_m, resolution_m = params_.sensor.resolution_m;
  const double noise_m = random.normal(params_.sensor.noise_sigma_m);
  const bool is_dropped = random.uniform() < params_.sensor.dropped_share;
  double range_m = true_m + noise_m;
  if (is_dropped || !(range_m < range_max_m)) return range_max_m;
  if (resolution_m > 0) range_m = resolution_m * std::round(range_m / resolution_m);
  return std::clamp(range_m, resolution_m, range_max_m);
}

}  // namespace aisle
