#pragma once

#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/wall_grid.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// A 2-D range scanner and its faults. The defaults are an ordinary scanner of one reading a degree.
struct RangeScannerParams {
  int beams = 180;
  double first_angle_rad = -90 * kDegree;
  double angle_step_rad = 1 * kDegree;
  double range_max_m = 30;
  double noise_sigma_m = 0.01;
  double angle_offset_rad = 0;
  double resolution_m = 0.01;
  double dropped_share = 0.002;
  double mount_x_m = 0;
  double mount_y_m = 0;
  double mount_heading_rad = 0;
  double height_m = 0.3;

  void describe(FieldList& fields) {
    fields.count("beams", beams, {1, 4096}, "readings in a scan");
    fields.angle("first_angle_deg", first_angle_rad, {-180, 180},
                 "direction of the first reading; 0 is ahead");
    fields.angle("angle_step_deg", angle_step_rad, {0.01, 90},
                 "from one reading to the next, counter-clockwise");
    fields.real("range_max_m", range_max_m, {0.5, 200},
                "readings of this or more mean that nothing was seen");
    fields.real("noise_sigma_m", noise_sigma_m, {0, 1}, "standard deviation of a reading");
    fields.angle("angle_offset_deg", angle_offset_rad, {-10, 10},
                 "how far left of the logged angles it really looks");
    fields.real("resolution_m", resolution_m, {0, 0.5},
                "readings are whole multiples of this; 0: not rounded");
    fields.real("dropped_share", dropped_share, {0, 1}, "share of readings that miss the wall, as on glass");
    fields.real("mount_x_m", mount_x_m, {-5, 5}, "scanner ahead of the vehicle's origin");
    fields.real("mount_y_m", mount_y_m, {-5, 5}, "scanner left of the vehicle's origin");
    fields.angle("mount_heading_deg", mount_heading_rad, {-180, 180}, "scanner turned against the vehicle");
    fields.real("height_m", height_m, {0, 3}, "scanner above the floor");
  }
};

/// Measures a world by ray casting.
class RangeScanner {
 public:
  RangeScanner(const World& world, const RangeScannerParams& params);

  /// What the vehicle believes of its scanner: everything but the faults.
  LaserScanner description() const;

  /// One reading a beam [m]; range_max_m: nothing seen.
  std::vector<float> scan(const Pose2& T_world_vehicle, Random& random) const;

 private:
  double reading_m(double true_m, Random& random) const;

  RangeScannerParams params_;
  WallGrid walls_;
};

}  // namespace aisle
