/// What `aisle connect` says of a robot.
#include <gmock/gmock.h>

#include "aisle/connection/robot_check.hpp"
#include "aisle/connection/robot_try.hpp"
#include "aisle/connection/topic_survey.hpp"
#include "scripted_robot.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class RobotJudgingTest : public testing::Test {
 protected:
  RobotJudgingTest() {
    robot.follows_commands = true;
    robot.stands_in_a_room = true;
    connection.clock = ConnectedClock::kArrival;  // the scripted clock is not this machine's
  }

  ConnectedVehicle::Surroundings surroundings() { return {robot.wire, robot.clock, robot, robot.noting()}; }
  VehicleDescription small_cart() const {
    VehicleDescription vehicle = cart();
    vehicle.footprint = {0.2, 0.2, 0.3, 0.3};
    vehicle.limits.acceleration_max_mps2 = 20;  // the scripted time runs faster than commands are sent
    vehicle.limits.turn_acceleration_max_rad_s2 = 100;
    return vehicle;
  }
  Result<RobotTry> tried() {
    auto vehicle = ConnectedVehicle::connect(connection, small_cart(), surroundings());
    return vehicle ? try_robot(**vehicle) : Result<RobotTry>(vehicle.problems());
  }
  std::string all_problems_of_trying() {
    const auto result = tried();
    return result ? (result->problems.empty() ? "none" : to_string(result->problems))
                  : to_string(result.problems());
  }

  ScriptedRobot robot;
  Connection connection = plain_connection();
};

TEST_F(RobotJudgingTest, ARobotThatMovesAsCommandedMayBeDriven) {
  const auto result = tried();
  ASSERT_TRUE(result.ok()) << to_string(result.problems());
  EXPECT_THAT(result->problems, IsEmpty());
  EXPECT_THAT(result->moves, SizeIs(4));
  EXPECT_TRUE(result->stops_by_itself);
}

TEST_F(RobotJudgingTest, AWrongSignIsSeenInTheScans) {
  robot.turn_sign = -1;
  EXPECT_THAT(all_problems_of_trying(), AllOf(HasSubstr("left: "), HasSubstr("the wrong way")));
}

TEST_F(RobotJudgingTest, AWrongScaleOfTheOdometryIsSeen) {
  robot.odometry_scale = 2;
  EXPECT_THAT(all_problems_of_trying(), HasSubstr("its odometry says"));
}

TEST_F(RobotJudgingTest, ARobotThatDoesNotMoveIsSaidTo) {
  robot.follows_commands = false;
  robot.speed_mps = 0;
  EXPECT_THAT(all_problems_of_trying(), HasSubstr("it hardly moved"));
}

TEST_F(RobotJudgingTest, ARobotThatDrivesOnWithoutCommandsIsSaidTo) {
  robot.stops_by_itself = false;
  const auto result = tried();
  ASSERT_TRUE(result.ok()) << to_string(result.problems());
  EXPECT_FALSE(result->stops_by_itself);
}

TEST_F(RobotJudgingTest, NothingMovesWithoutRoom) {
  robot.front_wall_m = 0.45;
  EXPECT_THAT(all_problems_of_trying(), HasSubstr("something stands"));
  for (const std::string& sent : robot.wire.sent("/cmd_vel")->all())
    EXPECT_EQ(*parse_cdr<ros::Twist>(sent), ros::Twist{});
}

TEST_F(RobotJudgingTest, ACheckCommandsNothingAndSaysHowOftenThingsCome) {
  const auto check = check_robot(connection, small_cart(), surroundings(), 3);
  ASSERT_TRUE(check.ok()) << to_string(check.problems());
  EXPECT_NEAR(check->scan.rate_hz(), 10, 0.5);
  EXPECT_NEAR(check->odometry.rate_hz(), 50, 1);
  EXPECT_EQ(check->beams, 360U);
  EXPECT_THAT(check->warnings, IsEmpty());
  EXPECT_THAT(robot.wire.sent("/cmd_vel")->all(), IsEmpty());
}

TEST_F(RobotJudgingTest, ACheckSaysThatARobotMovesByItself) {
  robot.follows_commands = false;
  robot.speed_mps = 0.3;
  const auto check = check_robot(connection, small_cart(), surroundings(), 1);
  ASSERT_TRUE(check.ok()) << to_string(check.problems());
  EXPECT_THAT(to_string(check->warnings), HasSubstr("though nothing was commanded"));
}

TEST_F(RobotJudgingTest, ACheckSaysHowFarTheClocksDiffer) {
  connection.clock = ConnectedClock::kStamps;
  const auto check = check_robot(connection, small_cart(), surroundings(), 1);
  ASSERT_TRUE(check.ok()) << to_string(check.problems());
  EXPECT_THAT(to_string(check->warnings), HasSubstr("behind this machine's clock"));
}

WireEndpoint published(const std::string& topic, const std::string& type) {
  return {WireEndpoint::Kind::kPublisher, topic, type, true, false, "robot"};
}
WireEndpoint subscribed(const std::string& topic, const std::string& type) {
  return {WireEndpoint::Kind::kSubscriber, topic, type, true, false, "robot"};
}

TEST(TopicSurvey, SaysWhatEachTopicCouldServeFor) {
  const auto topics = survey(
      {published("/scan", "sensor_msgs/msg/LaserScan"), published("/scan", "sensor_msgs/msg/LaserScan"),
       subscribed("/cmd_vel", "geometry_msgs/msg/TwistStamped"),
       published("/front/bumper", "std_msgs/msg/Bool"), published("/rosout", "rcl_interfaces/msg/Log")});
  ASSERT_THAT(topics, SizeIs(4));
  EXPECT_EQ(topics[0].use, "command");
  EXPECT_EQ(topics[1].use, "bumper");
  EXPECT_EQ(topics[2].use, "");
  EXPECT_EQ(topics[3].use, "scan");
  EXPECT_EQ(topics[3].publishers, 2U);
}

TEST(TopicSurvey, AConnectionTakesTheShortestNameAndSaysWhatElseThereIs) {
  Problems warnings;
  const auto connection = suggested_connection(
      survey({published("/scan", "sensor_msgs/msg/LaserScan"),
              published("/scan_filtered", "sensor_msgs/msg/LaserScan"),
              published("/odom", "nav_msgs/msg/Odometry"), subscribed("/cmd_vel", "geometry_msgs/msg/Twist"),
              published("/platform/emergency_stop", "std_msgs/msg/Bool")}),
      {}, warnings);
  ASSERT_TRUE(connection.ok()) << to_string(connection.problems());
  EXPECT_EQ(connection->scan.topic, "/scan");
  ASSERT_THAT(connection->emergency_stops, SizeIs(1));
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_EQ(to_string(warnings.front()), "/scan: was taken as the scan; there are also /scan_filtered");
}

TEST(TopicSurvey, WhatIsMissingIsSaidAllAtOnce) {
  Problems warnings;
  const auto connection = suggested_connection({}, {}, warnings);
  ASSERT_FALSE(connection.ok());
  EXPECT_THAT(connection.problems(), SizeIs(3));
}

}  // namespace
}  // namespace aisle
