#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "aisle/formats/bags/bag_scan.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The angles at which a vehicle's scans are given.
struct BeamGrid {
  LaserScanner scanner;
  std::size_t beams = 0;
};

/// When the last reading of a scan was taken, by the clock of its stamp, which is that of the first one.
double end_of_scan_s(const BagScan& scan);

/// The readings of a scan as a vehicle's scanner would have had them that measured all at once at the scan's
/// end: each is moved by what the vehicle has moved since, and laid onto the grid's beams. A beam between two
/// neighbouring readings of one surface gets the range of the line between them.
/// @param T_odom_vehicle  where the vehicle was, by the clock of the stamp
/// @return one range a beam: scanner.range_max_m: nothing seen; 0: nothing usable
std::vector<float> fitted_ranges(const BagScan& scan, const BeamGrid& grid,
                                 const std::function<Pose2(double stamp_s)>& T_odom_vehicle);

}  // namespace aisle
