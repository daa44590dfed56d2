#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "ros/messages.hpp"
#include "ros/participant.hpp"
#include "running_robot.hpp"

namespace robots {
namespace {

/// Messages come many times a second; after so long, none will come.
constexpr double kTimeout_s = 60;

class MujocoRobot : public testing::Test {
 protected:
  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {"--world",  AISLE_SOURCE_DIR "/worlds/l-corridor.yaml",
                                    "--domain", std::to_string(domain),
                                    "--report", report_path,
                                    "--clock",  "--speed",
                                    "5"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  nlohmann::json report() const { return nlohmann::json::parse(std::ifstream(report_path)); }

  const unsigned domain = domain_of_this_process();
  const std::string report_path = testing::TempDir() + "mujoco_robot_" + std::to_string(domain) + ".json";
};

/// The robot's odometry is the clock: a command for each message of it, for a second of its time.
void drive_for_a_second(const Subscription<Odometry>& odometry, const Publisher<Twist>& commands,
                        double speed_mps) {
  Twist command;
  command.linear.x = speed_mps;
  std::optional<double> first_s;
  while (true) {
    const auto message = odometry.wait(kTimeout_s);
    ASSERT_TRUE(message) << "the odometry is silent";
    if (commands.subscribers() == 0) continue;
    const double now_s = message->header.stamp.seconds();
    if (!first_s) first_s = now_s;
    if (now_s > *first_s + 1) return;
    commands.publish(command);
  }
}

void wait_until_it_stands(const Subscription<Odometry>& odometry) {
  while (true) {
    const auto message = odometry.wait(kTimeout_s);
    ASSERT_TRUE(message) << "the odometry is silent";
    if (std::abs(message->twist.linear.x) < 0.001) return;
  }
}

TEST_F(MujocoRobot, DrivesAsCommandedAndStopsHalfASecondAfterTheLastCommand) {
  RunningRobot robot(arguments({}));
  robot.wait_until_ready();
  const Participant participant(domain);
  const Publisher<Twist> commands(participant, "/cmd_vel", Quality::kDefault);
  const Subscription<Odometry> odometry(participant, "/odom", Quality::kDefault);
  drive_for_a_second(odometry, commands, 0.3);
  wait_until_it_stands(odometry);
  ASSERT_EQ(robot.stop(), 0);

  // However late the commands came on a busy machine, the report says what was commanded.
  const nlohmann::json done = report();
  const double commanded_m = done["commanded_path_m"];
  EXPECT_GT(commanded_m, 0.14) << "the first command alone is obeyed for half a second";
  EXPECT_NEAR(done["true_path_m"], commanded_m, 0.05 * commanded_m);
  EXPECT_NEAR(done["true_end"]["x_m"], 1.2 + commanded_m, 0.05 * commanded_m);
  EXPECT_NEAR(done["true_end"]["y_m"], 1.05, 0.02);
  EXPECT_NEAR(done["odometry_end"]["x_m"], commanded_m, 0.05 * commanded_m);
  const double stopped_after_s = done["last_motion_s"].get<double>() - done["last_command_s"].get<double>();
  EXPECT_GE(stopped_after_s, 0.5);
  EXPECT_LE(stopped_after_s, 0.9) << "half a second, and the time to brake";
  EXPECT_EQ(done["contacts"]["count"], 0);
}

TEST_F(MujocoRobot, ScansTheWallsToItsLeftAndRight) {
  RunningRobot robot(arguments({"--start", "4,0.7,0", "--namespace", "/r"}));
  robot.wait_until_ready();
  const Participant participant(domain);
  const auto scan = Subscription<LaserScan>(participant, "/r/scan", Quality::kSensor).wait(kTimeout_s);
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->ranges.size(), 360u);
  const auto range_m = [&](double angle_rad) {
    return scan->ranges.at(std::lround((angle_rad - scan->angle_min) / scan->angle_increment));
  };
  constexpr double kSixSigma_m = 0.06;
  EXPECT_NEAR(range_m(M_PI / 2), 2.1 - 0.7, kSixSigma_m);
  EXPECT_NEAR(range_m(-M_PI / 2), 0.7, kSixSigma_m);
  EXPECT_EQ(robot.stop(), 0);
}

TEST_F(MujocoRobot, RefusesUnknownOptions) {
  RunningRobot robot(arguments({"--sideways"}));
  EXPECT_EQ(robot.wait(), 2);
}

}  // namespace
}  // namespace robots
