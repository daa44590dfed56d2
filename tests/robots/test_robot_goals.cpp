/// A robot that is sent about by its own viewer, as RViz and Foxglove do it: simulated in MuJoCo.
#include <gmock/gmock.h>

#include <cmath>
#include <csignal>
#include <memory>

#include "ros/messages.hpp"
#include "ros/participant.hpp"
#include "run_aisle.hpp"
#include "running_robot.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

using robots::Quality;
using testing::HasSubstr;

class RobotGoals : public Workplace {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_aisle({"explore", "l-corridor", "--vehicle", "turtlebot", "--out", at("floor")}).exit_code,
              0);
    robot.wait_until_ready();
    file("cart.yaml",
         "format: aisle.vehicle\nversion: 1\nname: cart\nis_differential: true\n"
         "footprint: {front_m: 0.25, rear_m: 0.1, width_m: 0.3}\n");
    file("robot.yaml",
         "format: aisle.connection\nversion: 1\nvehicle: cart.yaml\nclock: ros\nnetwork: {domain: " +
             domain() + "}\n");
    aisle = std::make_unique<RunningAisle>(
        Arguments{"go", at("floor/building.json"), "--connect", at("robot.yaml")});
    ASSERT_TRUE(says("waits for goals on /goal_pose")) << aisle->error_so_far();
    wait_until_heard();
  }
  void TearDown() override {
    if (!aisle) return;
    aisle->signal(SIGINT);
    EXPECT_EQ(aisle->wait().exit_code, 130);
  }

  static std::string domain() { return std::to_string(robots::domain_of_this_process()); }

  /// What is published before both ends know of each other is lost.
  void wait_until_heard() {
    constexpr int kAlsoOnTheOtherSide = 50;  // messages of the robot
    while (goal.subscribers() == 0 || initial_pose.subscribers() == 0) {
      see_robot();
      ASSERT_FALSE(HasFailure());
    }
    for (int i = 0; i < kAlsoOnTheOtherSide; ++i) see_robot();
  }

  /// The robot's odometry wakes.
  bool says(const std::string& words) {
    constexpr int kMessages = 10'000;
    for (int i = 0; i < kMessages && aisle->error_so_far().find(words) == std::string::npos; ++i) see_robot();
    return aisle->error_so_far().find(words) != std::string::npos;
  }

  void see_robot() {
    constexpr double kSilent_s = 10;
    const auto odometry = odometry_.wait(kSilent_s);
    ASSERT_TRUE(odometry);
    at_ = odometry->pose.position;
  }

  void send_to(double x_m, double y_m, const std::string& frame = "map") const {
    goal.publish({{{}, frame}, {{x_m, y_m, 0}, {}}});
  }

  void say_it_stands_at(double x_m, double y_m, double heading_rad) const {
    initial_pose.publish(
        {{{}, "map"}, {{x_m, y_m, 0}, {0, 0, std::sin(heading_rad / 2), std::cos(heading_rad / 2)}}});
  }

  double off_m(double x_m, double y_m) const { return std::hypot(at_.x - x_m, at_.y - y_m); }

  robots::RunningRobot robot{{"--world", AISLE_SOURCE_DIR "/worlds/l-corridor.yaml", "--domain", domain(),
                              "--clock", "--speed", "2"}};
  const robots::Participant participant{robots::domain_of_this_process()};
  const robots::Publisher<robots::PoseStamped> goal{participant, "/goal_pose", Quality::kDefault};
  const robots::Publisher<robots::PoseWithCovarianceStamped> initial_pose{participant, "/initialpose",
                                                                          Quality::kDefault};
  const robots::Subscription<robots::Odometry> odometry_{participant, "/odom", Quality::kDefault};
  robots::Vector3 at_;
  std::unique_ptr<RunningAisle> aisle;
};

TEST_F(RobotGoals, AreDrivenToAndTheNewestReplacesTheOneBefore) {
  send_to(2, 5);
  EXPECT_TRUE(says("goal 2.00, 5.00 refused: no free floor is known there"));
  send_to(2, 0, "odom");
  EXPECT_TRUE(says("/goal_pose is in the frame 'odom', not in 'map'"));
  send_to(NAN, 0);
  EXPECT_TRUE(says("/goal_pose is no pose"));
  send_to(8, 0);
  while (off_m(0, 0) < 0.5) see_robot();
  send_to(2.5, 0);
  EXPECT_TRUE(says("goal 2.50, 0.00: arrived")) << aisle->error_so_far();
  EXPECT_LT(off_m(2.5, 0), 0.7);
  send_to(0, 0);
  EXPECT_TRUE(says("goal 0.00, 0.00: arrived")) << aisle->error_so_far();
  EXPECT_LT(off_m(0, 0), 0.7);
}

TEST_F(RobotGoals, AStatedPoseIsBelievedOnlyWhereTheScansFit) {
  say_it_stands_at(5, 0, M_PI / 2);
  EXPECT_TRUE(says("initial pose 5.00, 0.00, 90 deg refused")) << aisle->error_so_far();
  say_it_stands_at(5, 9, 0);
  EXPECT_TRUE(says("initial pose 5.00, 9.00, 0 deg refused: no free floor")) << aisle->error_so_far();
  say_it_stands_at(0.2, -0.1, 0.1);
  EXPECT_TRUE(says("stands at")) << aisle->error_so_far();
}

TEST_F(RobotGoals, DiagnosticsSayWhatHappensAndOthersMapsAreLeftToThem) {
  const robots::Subscription<robots::DiagnosticArray> diagnostics(participant, "/diagnostics",
                                                                  Quality::kDefault);
  const auto reports = [&](const std::string& words) {
    constexpr double kUnsaid_s = 20;
    while (const auto message = diagnostics.wait(kUnsaid_s)) {
      if (message->status.at(0).message.find(words) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(reports("driving"));
  participant.writer("/map", "nav_msgs/msg/OccupancyGrid", Quality::kLatched);
  const robots::Publisher<robots::TFMessage> transforms(participant, "/tf", Quality::kDefault);
  while (aisle->error_so_far().find("the transform from map to odom") == std::string::npos) {
    transforms.publish({{{{{}, "map"}, "odom", {1, 0, 0}, {}}}});
    see_robot();
    ASSERT_FALSE(HasFailure());
  }
  send_to(2.5, 0);  // it learns more of the floor, and has a path
  EXPECT_TRUE(says("/map is published by another program")) << aisle->error_so_far();
  const robots::Publisher<robots::Twist> joystick(participant, "/cmd_vel", Quality::kDefault);
  EXPECT_TRUE(reports("held: another program sends commands on /cmd_vel"));
}

}  // namespace
}  // namespace aisle
