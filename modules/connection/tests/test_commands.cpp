#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/vehicle/front_steered.hpp"
#include "command_outlet.hpp"
#include "command_topic.hpp"
#include "fake_wire.hpp"

namespace aisle {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kTopic = "/cmd_vel";

ros::Twist twist_in(const std::string& message) {
  return *parse_cdr<ros::Twist>(message);
}

bool is_stop(const std::string& message) {
  return twist_in(message) == ros::Twist{};
}

VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  return vehicle;
}

/// An outlet whose clock the test moves.
class CommandOutletTest : public testing::Test {
 protected:
  std::unique_ptr<CommandOutlet> outlet_of(const VehicleDescription& vehicle) {
    return std::make_unique<CommandOutlet>(
        std::make_unique<FakePublisher>(sent), CommandOutlet::Settings{CommandKind::kTwist, 0.3, "base_link"},
        vehicle, [this] { return clock.now_s(); }, [] { return ros::Stamp_ns{0}; });
  }

  MovedClock clock;
  std::shared_ptr<SentMessages> sent = std::make_shared<SentMessages>();
};

TEST_F(CommandOutletTest, SendsTheLatestCommand) {
  VehicleDescription vehicle = cart();
  vehicle.limits.acceleration_max_mps2 = 20;
  const auto outlet = outlet_of(vehicle);
  clock.move(1);
  outlet->act({.speed_mps = 0.4});
  sent->wait_for_newest([](const std::string& m) { return twist_in(m).linear.x == 0.4; });
}

TEST_F(CommandOutletTest, GetsFasterWithinTheLimitsAndSlowerAtOnce) {
  const auto outlet = outlet_of(cart());  // 0.5 m/s2
  clock.move(1);
  outlet->act({.speed_mps = 0.4});
  sent->wait_for_newest([](const std::string& m) { return twist_in(m).linear.x > 0; });
  EXPECT_LE(twist_in(sent->all().back()).linear.x, 0.5 * 0.25 + 1e-9) << "of at most a quarter of a second";
  outlet->act({.speed_mps = 0});
  sent->wait_for_newest(is_stop);
}

TEST_F(CommandOutletTest, GetsSlowerOnceTheNextDecisionIsLate) {
  VehicleDescription vehicle = cart();
  vehicle.cycle_s = 0.1;
  vehicle.limits.acceleration_max_mps2 = 20;
  const auto outlet = outlet_of(vehicle);
  clock.move(1);
  outlet->act({.speed_mps = 0.4});
  sent->wait_for_newest([](const std::string& m) { return twist_in(m).linear.x == 0.4; });
  clock.move(0.225);  // in the middle between one and a half cycles and the greatest age
  sent->wait_for_newest([](const std::string& m) { return std::abs(twist_in(m).linear.x - 0.2) < 1e-6; });
}

TEST_F(CommandOutletTest, ACommandThatBecomesTooOldIsReplacedByAStop) {
  const auto outlet = outlet_of(cart());
  clock.move(1);
  outlet->act({.speed_mps = 0.4});
  sent->wait_for_newest([](const std::string& m) { return twist_in(m).linear.x > 0; });
  clock.move(0.31);
  sent->wait_for_newest(is_stop);
  EXPECT_EQ(outlet->aged(), 1U);
}

TEST_F(CommandOutletTest, WhileItIsHeldItSendsStopsAndForgetsWhatItWasTold) {
  const auto outlet = outlet_of(cart());
  clock.move(1);
  outlet->act({.speed_mps = 0.4});
  sent->wait_for_newest([](const std::string& m) { return twist_in(m).linear.x > 0; });
  outlet->hold(true);
  sent->wait_for_newest(is_stop);
  outlet->act({.speed_mps = 0.3});
  outlet->hold(false);
  sent->wait_for_more_than(sent->all().size());
  EXPECT_TRUE(is_stop(sent->all().back()));
}

TEST_F(CommandOutletTest, EndsWithTenStops) {
  auto outlet = outlet_of(cart());
  clock.move(1);
  outlet->act({.speed_mps = 0.4});
  sent->wait_for_newest([](const std::string& m) { return twist_in(m).linear.x > 0; });
  outlet.reset();
  const std::vector<std::string> all = sent->all();
  ASSERT_GE(all.size(), 10U);
  for (std::size_t i = all.size() - 10; i < all.size(); ++i) EXPECT_TRUE(is_stop(all[i])) << i;
}

TEST(CommandMessages, CommandsStayWithinTheLimits) {
  const DriveLimits limits;
  EXPECT_EQ(within(limits, {.speed_mps = 9}).speed_mps, limits.speed_max_mps);
  EXPECT_EQ(within(limits, {.speed_mps = -9}).speed_mps, -limits.reverse_speed_max_mps);
  EXPECT_EQ(within(limits, {.steering_rad = 2}).steering_rad, limits.steering_max_rad);
  EXPECT_EQ(within(limits, {.turn_rate_rad_s = -9}).turn_rate_rad_s, -limits.turn_rate_max_rad_s);
}

TEST(CommandMessages, WhatIsNoNumberIsAStop) {
  EXPECT_EQ(within({}, {.speed_mps = kNan}), Command{});
  EXPECT_EQ(within({}, {.speed_mps = 1, .steering_rad = kNan}), Command{});
  EXPECT_EQ(within({}, {.speed_mps = 1, .turn_rate_rad_s = HUGE_VAL}), Command{});
}

TEST(CommandMessages, ATwistTurnsAFrontSteeredVehicleAsItsSteeringWould) {
  VehicleDescription car;
  car.front_steered.wheelbase_m = 0.5;
  const Command command{.speed_mps = 0.4, .steering_rad = 0.3};
  const ros::Twist twist = twist_in(command_cdr(command, CommandKind::kTwist, car, 0, ""));
  const Arc arc = arc_of(car.front_steered, {0.4, 0.3});  // in one second
  EXPECT_NEAR(twist.linear.x, arc.length_m, 1e-9);
  EXPECT_NEAR(twist.angular.z, arc.turn_rad, 1e-9);
}

TEST(CommandMessages, AStampedTwistHasTheRobotsTimeAndFrame) {
  const auto message = parse_cdr<ros::TwistStamped>(
      command_cdr({.speed_mps = 0.2}, CommandKind::kTwistStamped, cart(), 1'500'000'000, "base"));
  EXPECT_EQ(message->header.stamp, (ros::Time{1, 500'000'000}));
  EXPECT_EQ(message->header.frame_id, "base");
  EXPECT_EQ(message->twist.linear.x, 0.2);
}

TEST(CommandMessages, AckermannHasTheSpeedOfTheRearAxle) {
  const VehicleDescription car;
  const auto message = parse_cdr<ros::AckermannDriveStamped>(
      command_cdr({.speed_mps = 0.4, .steering_rad = 0.3}, CommandKind::kAckermann, car, 0, ""));
  EXPECT_NEAR(message->drive.speed, 0.4 * std::cos(0.3), 1e-6);
  EXPECT_NEAR(message->drive.steering_angle, 0.3, 1e-6);
}

WireEndpoint reads(const std::string& type) {
  return {WireEndpoint::Kind::kSubscriber, kTopic, type, true, false, "robot"};
}

TEST(CommandTopic, TheKindIsTheOneThatTheRobotReads) {
  EXPECT_EQ(*kind_read({reads("geometry_msgs/msg/Twist")}, kTopic, CommandKind::kAuto), CommandKind::kTwist);
  EXPECT_EQ(*kind_read({reads("geometry_msgs/msg/TwistStamped")}, kTopic, CommandKind::kAuto),
            CommandKind::kTwistStamped);
}

TEST(CommandTopic, IsRefusedWhereNobodyReadsOrItIsNotClearWhat) {
  EXPECT_FALSE(kind_read({}, kTopic, CommandKind::kAuto).ok());
  EXPECT_FALSE(kind_read({reads("std_msgs/msg/String")}, kTopic, CommandKind::kAuto).ok());
  const std::vector<WireEndpoint> both{reads("geometry_msgs/msg/Twist"),
                                       reads("geometry_msgs/msg/TwistStamped")};
  EXPECT_FALSE(kind_read(both, kTopic, CommandKind::kAuto).ok());
  EXPECT_EQ(*kind_read(both, kTopic, CommandKind::kTwist), CommandKind::kTwist);
  EXPECT_FALSE(kind_read({reads("geometry_msgs/msg/Twist")}, kTopic, CommandKind::kAckermann).ok());
}

TEST(CommandTopic, AnotherProgramThatCommandsIsAnObstacle) {
  std::vector<WireEndpoint> endpoints{reads("geometry_msgs/msg/Twist")};
  EXPECT_EQ(command_obstacle(endpoints, kTopic, CommandKind::kTwist), "");
  endpoints.push_back(
      {WireEndpoint::Kind::kPublisher, kTopic, "geometry_msgs/msg/Twist", true, false, "teleop"});
  EXPECT_EQ(command_obstacle(endpoints, kTopic, CommandKind::kTwist),
            "another program sends commands on /cmd_vel");
  EXPECT_EQ(command_obstacle({}, kTopic, CommandKind::kTwist), "nobody reads the commands on /cmd_vel");
}

}  // namespace
}  // namespace aisle
