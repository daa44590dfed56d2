#include "aisle/vehicle/laser_log.hpp"

#include <utility>

#include "aisle/core/median.hpp"

namespace aisle {

void LaserScanner::describe(FieldList& fields) {
  fields.angle("first_angle_deg", first_angle_rad, {-180, 180}, "direction of the first reading; 0 is ahead");
  fields.angle("angle_step_deg", angle_step_rad, {0.01, 90},
               "from one reading to the next, counter-clockwise");
  fields.real("range_max_m", range_max_m, {0.5, 200}, "readings of this or more mean that nothing was seen");
  fields.real("mount_x_m", T_vehicle_laser.x, {-5, 5}, "scanner ahead of the vehicle's origin");
  fields.real("mount_y_m", T_vehicle_laser.y, {-5, 5}, "scanner left of the vehicle's origin");
  fields.angle("mount_heading_deg", T_vehicle_laser.theta, {-180, 180}, "scanner turned against the vehicle");
}

LaserScanner LaserLog::laser_of(const LaserScan& scan) const {
  LaserScanner laser = lasers[scan.laser];
  if (scan.beams) {
    laser.first_angle_rad = scan.beams->first_angle_rad;
    laser.angle_step_rad = scan.beams->angle_step_rad;
  }
  return laser;
}

double LaserLog::scan_period_s() const {
  if (scans.size() < 2) return 0;
  std::vector<double> steps(scans.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = scans[i + 1].time_s - scans[i].time_s;
  return median(std::move(steps));
}

}  // namespace aisle
