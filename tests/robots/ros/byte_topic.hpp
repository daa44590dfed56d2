#pragma once

#include <dds/dds.h>

#include <string>

namespace robots {

/// A topic whose type Cyclone DDS knows by name alone: a sample is a std::string that holds the message's CDR
/// with its encapsulation. That is all that a ROS 2 message is on the wire, so no IDL is needed.
/// @param topic as DDS says it: "rt/scan"
/// @param type as DDS says it: "sensor_msgs::msg::dds_::LaserScan_"
/// @return negative: an error of DDS
dds_entity_t create_byte_topic(dds_entity_t participant, const std::string& topic, const std::string& type);

}  // namespace robots
