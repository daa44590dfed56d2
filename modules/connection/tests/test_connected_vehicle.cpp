#include <gmock/gmock.h>

#include <cmath>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/vehicle/odometry_step.hpp"
#include "pose_matchers.hpp"
#include "scripted_robot.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ConnectedVehicleTest : public testing::Test {
 protected:
  Result<std::unique_ptr<ConnectedVehicle>> connect() {
    return ConnectedVehicle::connect(connection, cart(), {robot.wire, robot.clock, robot, robot.noting()});
  }
  std::string problem_of_connecting() {
    const auto vehicle = connect();
    return vehicle ? "connected" : to_string(vehicle.problems().front());
  }

  ScriptedRobot robot;
  Connection connection = plain_connection();
};

TEST_F(ConnectedVehicleTest, TheScannerIsWhatTheScansAndTheMountSay) {
  const auto vehicle = connect();
  ASSERT_TRUE(vehicle.ok()) << to_string(vehicle.problems().front());
  const VehicleDescription& description = (*vehicle)->description();
  EXPECT_NEAR(description.scanner->first_angle_rad, -1, 1e-6);
  EXPECT_NEAR(description.scanner->angle_step_rad, 0.5, 1e-6);
  EXPECT_NEAR(description.scanner->range_max_m, 8, 1e-6);
  EXPECT_THAT(description.scanner->T_vehicle_laser, PoseNear(Pose2{0.1, 0, 0}, 1e-9, 1e-9));
  EXPECT_NEAR(description.cycle_s, 0.1, 1e-6);
}

TEST_F(ConnectedVehicleTest, AFullCircleOfFewDigitsIsDescribedWithinACircle) {
  robot.stands_in_a_room = true;  // its angles are single-precision numbers
  const auto vehicle = connect();
  ASSERT_TRUE(vehicle.ok());
  const VehicleDescription& description = (*vehicle)->description();
  EXPECT_GE(description.scanner->first_angle_rad, -kPi);
  EXPECT_TRUE(parse_vehicle(vehicle_yaml(description), "robot").ok()) << "sessions keep the description";
  EXPECT_EQ((*vehicle)->sense()->scan->ranges_m.size(), 360U);
}

TEST_F(ConnectedVehicleTest, ObservationsHaveTheScanAndTheWayToIt) {
  const auto vehicle = connect();
  const auto first = (*vehicle)->sense();
  EXPECT_NEAR(first->stamp_s, 0.1, 1e-6);
  EXPECT_THAT(first->scan->ranges_m, ElementsAre(1, 2, 3, 8, 0));
  double driven_m = 0;
  for (int i = 1; i <= 20; ++i) {
    const auto observation = (*vehicle)->sense();
    EXPECT_NEAR(observation->stamp_s, 0.1 * (i + 1), 1e-6);
    driven_m += odometry_step((*vehicle)->description(), observation->odometry).x;
  }
  EXPECT_NEAR(driven_m, 20 * 0.1 * 0.3, 0.01);
}

TEST_F(ConnectedVehicleTest, AScannerThatHangsUpsideDownIsTurnedOver) {
  robot.is_upside_down = true;
  const auto vehicle = connect();
  EXPECT_THAT((*vehicle)->sense()->scan->ranges_m, ElementsAre(0, 8, 3, 2, 1));
}

TEST_F(ConnectedVehicleTest, TheAxleMayLieElsewhereThanTheRobotsBaseFrame) {
  connection.frames.p_base_axle_m = {-0.2, 0};
  const auto vehicle = connect();
  EXPECT_THAT((*vehicle)->description().scanner->T_vehicle_laser, PoseNear(Pose2{0.3, 0, 0}, 1e-9, 1e-9));
}

TEST_F(ConnectedVehicleTest, LimitsAreOnlyEverLowered) {
  connection.limits.speed_max_mps = 0.2;
  EXPECT_EQ((*connect())->description().limits.speed_max_mps, 0.2);
  connection.limits.speed_max_mps = 5;
  EXPECT_THAT(problem_of_connecting(), HasSubstr("above the vehicle's own limit"));
}

TEST_F(ConnectedVehicleTest, WithoutScansItSaysWhatThereIs) {
  connection.scan.topic = "lidar";
  EXPECT_THAT(problem_of_connecting(),
              testing::AllOf(HasSubstr("/lidar"), HasSubstr("/scan (sensor_msgs/msg/LaserScan)")));
}

TEST_F(ConnectedVehicleTest, ATopicOfAnotherTypeIsNamed) {
  connection.scan.topic = "points";
  robot.wire.endpoints_of_others.push_back(
      {WireEndpoint::Kind::kPublisher, "/points", "sensor_msgs/msg/PointCloud2", false, false, "robot"});
  EXPECT_THAT(problem_of_connecting(),
              HasSubstr("is a sensor_msgs/msg/PointCloud2, not a sensor_msgs/msg/LaserScan"));
}

TEST_F(ConnectedVehicleTest, APublisherThatIsSilentIsSaidToBe) {
  robot.sends_scans = false;
  EXPECT_THAT(problem_of_connecting(), HasSubstr("is published, but nothing readable of it arrived"));
}

TEST_F(ConnectedVehicleTest, AScannerWithoutAMountIsRefused) {
  robot.has_mount = false;
  EXPECT_THAT(problem_of_connecting(), HasSubstr("no fixed transforms lead from 'base_link' to 'laser'"));
}

TEST_F(ConnectedVehicleTest, NothingIsCommandedWhereSomebodyElseCommands) {
  robot.wire.endpoints_of_others.push_back(
      {WireEndpoint::Kind::kPublisher, "/cmd_vel", "geometry_msgs/msg/Twist", true, false, "teleop"});
  EXPECT_THAT(problem_of_connecting(), HasSubstr("another program sends commands on /cmd_vel"));
  EXPECT_TRUE(robot.wire.sent("/cmd_vel")->all().empty());
}

TEST_F(ConnectedVehicleTest, NothingIsCommandedWhereNobodyReads) {
  robot.wire.endpoints_of_others.clear();
  EXPECT_THAT(problem_of_connecting(), HasSubstr("nobody reads this topic"));
  EXPECT_TRUE(robot.wire.sent("/cmd_vel")->all().empty());
}

TEST_F(ConnectedVehicleTest, AnEmptyBatteryStartsNothing) {
  connection.battery = {"battery", 0.2};
  robot.script = [&] {
    ros::BatteryState battery;
    battery.percentage = 0.1F;
    robot.wire.tell("/battery", cdr_bytes(battery));
  };
  EXPECT_THAT(problem_of_connecting(), HasSubstr("has 10 % left"));
}

TEST_F(ConnectedVehicleTest, EndsWhenTheScansAreSilent) {
  const auto vehicle = connect();
  EXPECT_TRUE((*vehicle)->sense().has_value());
  robot.sends_scans = false;
  EXPECT_FALSE((*vehicle)->sense().has_value());
  EXPECT_EQ((*vehicle)->end_reason(), "/scan silent for 1.0 s");
}

TEST_F(ConnectedVehicleTest, IsHeldWithoutOdometryAndGoesOnWithIt) {
  const auto vehicle = connect();
  EXPECT_TRUE((*vehicle)->sense().has_value());
  const long gone = robot.ticks;
  robot.script = [&] { robot.sends_odometry = robot.ticks - gone < 5 || robot.ticks - gone > 40; };
  for (int i = 0; i < 10; ++i) EXPECT_TRUE((*vehicle)->sense().has_value());
  EXPECT_THAT(robot.notes, ElementsAre("held: /odom is silent", "goes on"));
  EXPECT_EQ((*vehicle)->counts().holds, 1U);
}

TEST_F(ConnectedVehicleTest, EndsWhenTheOdometryStaysSilent) {
  const auto vehicle = connect();
  robot.sends_odometry = false;
  while ((*vehicle)->sense()) {
  }
  EXPECT_EQ((*vehicle)->end_reason(), "/odom silent for 1.0 s");
}

TEST_F(ConnectedVehicleTest, OneLeapOfTheOdometryIsLeftOutAndASecondEndsTheMission) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  robot.T_odom_base = robot.T_odom_base * Pose2{3, 0, 0};
  const long leapt = robot.ticks;
  const auto after = (*vehicle)->sense();
  EXPECT_GE(robot.ticks - leapt, 50) << "it stands still for a second";
  EXPECT_LT(odometry_step((*vehicle)->description(), after->odometry).position().norm(), 0.5);
  EXPECT_EQ((*vehicle)->counts().odometry_leaps, 1U);
  robot.T_odom_base = robot.T_odom_base * Pose2{0, 3, 0};
  while ((*vehicle)->sense()) {
  }
  EXPECT_THAT((*vehicle)->end_reason(), HasSubstr("leapt twice"));
}

TEST_F(ConnectedVehicleTest, ARestartedRobotEndsTheMission) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  robot.T_odom_base = {};
  while ((*vehicle)->sense()) {
  }
  EXPECT_THAT((*vehicle)->end_reason(), HasSubstr("restarted"));
}

TEST_F(ConnectedVehicleTest, AClockThatJumpsBackEndsTheMission) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  robot.stamp_s -= 100;
  while ((*vehicle)->sense()) {
  }
  EXPECT_EQ((*vehicle)->end_reason(), "the stamps of /odom jumped back by 100.0 s");
}

TEST_F(ConnectedVehicleTest, AClockThatJumpsAheadIsCountedAndTheWayIsKept) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  robot.stamp_s += 50;
  EXPECT_TRUE((*vehicle)->sense().has_value());
  EXPECT_EQ((*vehicle)->counts().clock_gaps, 1U);
  EXPECT_EQ((*vehicle)->counts().odometry_leaps, 0U);
}

TEST_F(ConnectedVehicleTest, WhileTheEmergencyStopIsPressedTheMissionsClockStandsStill) {
  connection.emergency_stops = {{"stop", 0}};
  const auto vehicle = connect();
  const double before_s = (*vehicle)->sense()->stamp_s;
  robot.tell_stop(true);
  const long pressed = robot.ticks;
  robot.script = [&] {
    if (robot.ticks == pressed + 250) robot.tell_stop(false);
  };
  const auto after = (*vehicle)->sense();
  EXPECT_NEAR(after->stamp_s, before_s + 0.1, 0.02);
  EXPECT_NEAR(odometry_step((*vehicle)->description(), after->odometry).x, 5 * 0.3, 0.05)
      << "the way that it was pushed";
  EXPECT_THAT(robot.notes, ElementsAre("held: the emergency stop /stop is pressed", "goes on"));
  EXPECT_NEAR((*vehicle)->counts().held_s, 5, 0.2);
}

TEST_F(ConnectedVehicleTest, ASilentEmergencyStopCountsAsPressed) {
  connection.emergency_stops = {{"stop", 0.5}};
  robot.script = [&] {
    if (robot.ticks < 100) robot.tell_stop(false);
  };
  const auto vehicle = connect();
  (*vehicle)->sense();
  const long from = robot.ticks;
  robot.script = [&] {
    if (robot.ticks > from + 50) throw Interrupted{};
  };
  EXPECT_THROW(while ((*vehicle)->sense()){}, Interrupted);
  EXPECT_THAT(robot.notes, ElementsAre("held: the emergency stop /stop is silent"));
}

TEST_F(ConnectedVehicleTest, IsHeldWhileAnotherProgramCommands) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  const WireEndpoint other{
      WireEndpoint::Kind::kPublisher, "/cmd_vel", "geometry_msgs/msg/Twist", true, false, "teleop"};
  robot.wire.endpoints_of_others.push_back(other);
  const long from = robot.ticks;
  robot.script = [&] {
    if (robot.ticks == from + 50) std::erase(robot.wire.endpoints_of_others, other);
  };
  for (int i = 0; i < 5; ++i) EXPECT_TRUE((*vehicle)->sense().has_value());
  EXPECT_THAT(robot.notes, ElementsAre("held: another program sends commands on /cmd_vel", "goes on"));
}

TEST_F(ConnectedVehicleTest, ABumperTouchesInTheCycleInWhichItIsPressed) {
  connection.bumpers = {{"bumper", 0}};
  const auto vehicle = connect();
  EXPECT_FALSE((*vehicle)->sense()->bumper_pressed);
  robot.wire.tell("/bumper", cdr_bytes(ros::Bool{true}));
  robot.wire.tell("/bumper", cdr_bytes(ros::Bool{false}));
  EXPECT_TRUE((*vehicle)->sense()->bumper_pressed);
  EXPECT_FALSE((*vehicle)->sense()->bumper_pressed);
}

TEST_F(ConnectedVehicleTest, MessagesThatCannotBeReadEndTheMission) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  robot.sends_scans = false;
  robot.script = [&] { robot.wire.tell("/scan", "nonsense"); };
  robot.sends_odometry = false;
  while ((*vehicle)->sense()) {
  }
  EXPECT_THAT((*vehicle)->end_reason(),
              HasSubstr("cannot be read, the last of them sensor_msgs/msg/LaserScan"));
}

TEST_F(ConnectedVehicleTest, ScansThatMakeNoSenseAreNotTaken) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  ros::LaserScan scan;
  scan.header = robot.header("laser");
  scan.angle_increment = 0.1F;
  scan.ranges = {1, 1, 1};
  scan.time_increment = 1e30F;
  robot.wire.tell("/scan", cdr_bytes(scan));
  scan.time_increment = 0;
  scan.header.stamp.sec = -5;
  robot.wire.tell("/scan", cdr_bytes(scan));
  EXPECT_EQ((*vehicle)->counts().unreadable, 2U);
  EXPECT_TRUE((*vehicle)->sense().has_value());
}

TEST_F(ConnectedVehicleTest, AScanWhoseTimeBetweenReadingsIsNoNumberIsTakenAtOnce) {
  robot.time_increment_s = NAN;
  const auto vehicle = connect();
  ASSERT_TRUE(vehicle.ok());
  EXPECT_THAT((*vehicle)->sense()->scan->ranges_m, ElementsAre(1, 2, 3, 8, 0));
}

TEST_F(ConnectedVehicleTest, OdometryThatIsNoNumberIsNotTaken) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  robot.T_odom_base.x = NAN;
  while ((*vehicle)->sense()) {
  }
  EXPECT_THAT((*vehicle)->end_reason(), HasSubstr("cannot be read, the last of them nav_msgs/msg/Odometry"));
}

TEST_F(ConnectedVehicleTest, ScansThatWaitTooLongAreSkippedAndTheWayIsKept) {
  const auto vehicle = connect();
  (*vehicle)->sense();
  for (int i = 0; i < 50; ++i) robot.report("", 0, 0);  // the mission thinks for a second
  double driven_m = 0;
  for (int i = 0; i < 3; ++i)
    driven_m += odometry_step((*vehicle)->description(), (*vehicle)->sense()->odometry).x;
  EXPECT_GE((*vehicle)->counts().scans_skipped, 7U);
  EXPECT_NEAR(driven_m, 0.3 * 1.1, 0.05);
}

TEST_F(ConnectedVehicleTest, AnInterruptionEndsInStops) {
  auto vehicle = connect();
  (*vehicle)->sense();
  (*vehicle)->act({.speed_mps = 0.3});
  robot.script = [] { throw Interrupted{}; };
  EXPECT_THROW((*vehicle)->sense(), Interrupted);
  vehicle->reset();
  const auto all = robot.wire.sent("/cmd_vel")->all();
  EXPECT_EQ(*parse_cdr<ros::Twist>(all.back()), ros::Twist{});
}

}  // namespace
}  // namespace aisle
