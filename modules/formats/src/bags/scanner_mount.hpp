#pragma once

#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "bags/bag_streams.hpp"

namespace aisle {

/// The vehicle's frame: that of which the odometry tells, or base_link.
std::string base_frame(const BagMotion& motion, const TransformTree& transforms);

/// Finds where a scanner sits; scans of one that hangs upside down are turned over.
/// @param scans    at least one
/// @param warning  with the place of a warning
/// @return whether the bag says it
bool mount_scanner(const TransformTree& transforms, const std::string& base, std::vector<BagScan>& scans,
                   LaserScanner& laser, Problem warning, Problems& warnings);

}  // namespace aisle
