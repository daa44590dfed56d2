#pragma once

#include "aisle/vehicle/laser_log.hpp"
#include "aisle/vision/range_segments.hpp"

namespace aisle {

/// What segments need to know of a log's scanner.
inline ScanGeometry scan_geometry(const LaserScanner& laser) {
  return {laser.first_angle_rad, laser.angle_step_rad, laser.range_max_m, {}};
}

}  // namespace aisle
