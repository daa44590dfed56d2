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
/// @param images  when each was taken, of the topic `image_topic`
/// @return the times of the images on the same clock, never decreasing
std::vector<double> fill_log(LaserLog& log, std::vector<std::vector<BagScan>>& scans,
                             const std::vector<std::string>& topics, const BagMotion& motion,
                             const std::string& image_topic, const std::vector<MessageTime>& images,
                             const std::string& file, Problems& warnings);

}  // namespace aisle
