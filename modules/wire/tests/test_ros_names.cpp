#include <gtest/gtest.h>

#include "ros_names.hpp"

namespace aisle {
namespace {

TEST(RosNames, TopicsAndTypesHaveTheirNamesInDds) {
  EXPECT_EQ(dds_topic("/scan"), "rt/scan");
  EXPECT_EQ(dds_topic("/robot/camera/image_raw"), "rt/robot/camera/image_raw");
  EXPECT_EQ(dds_type("sensor_msgs/msg/LaserScan"), "sensor_msgs::msg::dds_::LaserScan_");
}

TEST(RosNames, NamesInDdsAreReadBack) {
  EXPECT_EQ(ros_topic("rt/robot/scan"), "/robot/scan");
  EXPECT_EQ(ros_type("sensor_msgs::msg::dds_::LaserScan_"), "sensor_msgs/msg/LaserScan");
}

TEST(RosNames, ServicesActionsAndOthersAreNoTopics) {
  for (const char* other : {"rq/add/_service/requestRequest", "rr/addReply", "ros_discovery_info", "rt",
                            "rtx/scan", "rt/", "rt//scan", "rt/scan\n", "Square", ""})
    EXPECT_EQ(ros_topic(other), std::nullopt) << other;
}

TEST(RosNames, TypesThatAreNotOfRosKeepTheirName) {
  for (const char* other :
       {"ShapeType", "a::msg::dds_::B", "", "::", "example_interfaces::srv::dds_::Add_Request_"})
    EXPECT_EQ(ros_type(other), other);
}

TEST(RosNames, WhatIsNoNameIsKnown) {
  EXPECT_TRUE(is_ros_topic("/robot1/cmd_vel"));
  for (const char* wrong : {"", "/", "scan", "/scan/", "//scan", "/a b", "/sc\xc3\xa4n", "~/scan"})
    EXPECT_FALSE(is_ros_topic(wrong)) << wrong;
  EXPECT_TRUE(is_ros_type("std_msgs/msg/String"));
  for (const char* wrong : {"", "String", "std_msgs/String", "/msg/", "a/msg/b/c", "std_msgs/srv/Empty"})
    EXPECT_FALSE(is_ros_type(wrong)) << wrong;
  EXPECT_FALSE(is_ros_topic("/" + std::string(250, 'a')));
}

}  // namespace
}  // namespace aisle
