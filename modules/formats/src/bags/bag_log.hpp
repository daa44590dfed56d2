#pragma once

#include <string>
#include <vector>

#include "bags/bag_streams.hpp"

namespace aisle {

/// Puts scans and odometry into a log, on one clock and in the order of recording; describes its scanners but
/// for their mounting.
/// @param log     with one scanner for each topic
/// @param scans   of each topic, at least one; their readings are moved out
/// @param topics  the names, for warnings
void fill_log(LaserLog& log, std::vector<std::vector<BagScan>>& scans, const std::vector<std::string>& topics,
              const BagMotion& motion, const std::string& file, Problems& warnings);

}  // namespace aisle
