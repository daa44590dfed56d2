#pragma once

#include <optional>
#include <string>

namespace aisle {

/// How DDS calls what ROS 2 calls "/scan": "rt/scan".
std::string dds_topic(const std::string& ros_topic);
/// nullopt: it is no topic of ROS.
std::optional<std::string> ros_topic(const std::string& dds_topic);

/// "sensor_msgs/msg/LaserScan" -> "sensor_msgs::msg::dds_::LaserScan_"
std::string dds_type(const std::string& ros_type);
/// A type that is none of ROS keeps its name.
std::string ros_type(const std::string& dds_type);

}  // namespace aisle
