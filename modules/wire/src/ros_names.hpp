#pragma once
/// How ROS 2 names its topics and types in DDS: "/scan" is "rt/scan", "sensor_msgs/msg/LaserScan" is
/// "sensor_msgs::msg::dds_::LaserScan_".

#include <optional>
#include <string>
#include <string_view>

namespace aisle {

/// A full topic name: "/", then words of letters, digits and _, separated by "/".
bool is_ros_topic(std::string_view topic);
/// A message type: "package/msg/Name".
bool is_ros_type(std::string_view type);

/// @param topic, type  as ROS says them
std::string dds_topic(std::string_view topic);
std::string dds_type(std::string_view type);

/// @return nullopt if it is no topic of ROS: services, actions, and what is not ROS at all
std::optional<std::string> ros_topic(std::string_view dds);
/// @return the name as it is if it is not a message type of ROS
std::string ros_type(std::string_view dds);

}  // namespace aisle
