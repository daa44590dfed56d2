#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/bags/bag_reader.hpp"

namespace aisle {

/// What a bag contains, and what of it is of use here.
struct BagOverview {
  struct Topic {
    BagTopic topic;
    ros::Stamp_ns first = 0, last = 0;  ///< when its messages were recorded
    double rate_hz = 0;                 ///< 0 with fewer than two messages
    std::vector<std::string> frames;    ///< "laser", or "odom -> base_link"; at most 20
    std::string serves;                 ///< "scan", "odometry", "camera", "lens", "mounts" or "not read"
  };

  long messages = 0;
  ros::Stamp_ns first = 0, last = 0;
  std::vector<Topic> topics;
  Problems warnings;
};

/// BagOverview::Topic::serves of a topic.
std::string served_by(const BagTopic& topic);

/// Reads the whole bag.
Result<BagOverview> bag_overview(const std::filesystem::path& path);

}  // namespace aisle
