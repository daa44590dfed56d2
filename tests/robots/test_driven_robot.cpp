/// The program drives a robot that knows nothing of it: in MuJoCo's physics, over ROS 2, simulated.
#include <gmock/gmock.h>

#include <cmath>
#include <csignal>
#include <memory>
#include <optional>

#include "driven_robot.hpp"
#include "ros/messages.hpp"
#include "ros/participant.hpp"

namespace aisle {
namespace {

using robots::Participant;
using robots::Quality;
using robots::RunningRobot;
using testing::HasSubstr;

constexpr double kTimeout_s = 60;

/// How far the robot truly is from where it started.
double off_home_m(const nlohmann::json& report) {
  const nlohmann::json &start = report["true_start"], &end = report["true_end"];
  return std::hypot(end["x_m"].get<double>() - start["x_m"].get<double>(),
                    end["y_m"].get<double>() - start["y_m"].get<double>());
}

TEST_F(DrivenRobot, IsFoundCheckedTriedAndExploresInFourCommands) {
  RunningRobot robot(robot_arguments());
  const nlohmann::json ready = robot.wait_until_ready();
  const ProgramRun written = init(ready);
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const ProgramRun checked = run_aisle({"connect", "check", "--connect", connection(), "--json"});
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_NEAR(checked.json()["figures"]["scanner"]["x_m"], ready["laser"]["x_m"].get<double>(), 1e-3);
  const ProgramRun tried = run_aisle({"connect", "try", "--connect", connection(), "--json"});
  ASSERT_EQ(tried.exit_code, 0) << tried.out << tried.err;
  EXPECT_TRUE(tried.json()["figures"]["stops_by_itself"]);
  const ProgramRun explored = run_aisle(
      {"explore", "--connect", connection(), "--out", at("floor"), "--session", at("run"), "--json"});
  ASSERT_EQ(explored.exit_code, 0) << explored.out << explored.err;
  const nlohmann::json figures = explored.json()["figures"];
  EXPECT_FALSE(figures["simulated"]);
  EXPECT_TRUE(figures["came_home"]);
  EXPECT_FALSE(figures.contains("covered_share")) << "nobody knows the truth";
  ASSERT_EQ(robot.stop(), 0);
  EXPECT_LT(off_home_m(report()), 0.1);
  EXPECT_EQ(report()["contacts"]["count"], 0);
  EXPECT_EQ(run_aisle({"replay", at("run")}).exit_code, 0);
}

TEST_F(DrivenRobot, AFrontSteeredOneExploresAsWell) {
  RunningRobot robot(robot_arguments({"--drive", "front-steered", "--command", "ackermann"}));
  const nlohmann::json ready = robot.wait_until_ready();
  const ProgramRun written =
      init(ready, {"--front-steered", "--wheelbase", fmt::format("{}", ready["wheelbase_m"].get<double>())});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const ProgramRun explored = run_aisle({"explore", "--connect", connection(), "--json"});
  EXPECT_EQ(explored.exit_code, 0) << explored.out << explored.err;
  ASSERT_EQ(robot.stop(), 0);
  EXPECT_LT(off_home_m(report()), 0.1);
  EXPECT_EQ(report()["contacts"]["count"], 0);
}

TEST_F(DrivenRobot, ThatIsKilledEndsTheMissionWithTheReason) {
  auto robot = std::make_unique<RunningRobot>(robot_arguments());
  ASSERT_EQ(init(robot->wait_until_ready()).exit_code, 0);
  RunningAisle explorer({"explore", "--connect", connection(), "--json"});
  const Participant participant(robots::domain_of_this_process());
  const robots::Subscription<robots::Twist> commands(participant, "/cmd_vel", Quality::kDefault);
  while (const auto command = commands.wait(kTimeout_s)) {
    if (command->linear.x > 0) break;
  }
  robot.reset();
  const ProgramRun run = explorer.wait();
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr("/clock stands still"));
}

TEST_F(DrivenRobot, StandsStillWhenTheProgramIsInterrupted) {
  RunningRobot robot(robot_arguments());
  ASSERT_EQ(init(robot.wait_until_ready()).exit_code, 0);
  RunningAisle explorer({"explore", "--connect", connection()});
  const Participant participant(robots::domain_of_this_process());
  const robots::Subscription<robots::Twist> commands(participant, "/cmd_vel", Quality::kDefault);
  while (const auto command = commands.wait(kTimeout_s)) {
    if (command->linear.x > 0.1) break;
  }
  explorer.signal(SIGINT);
  std::optional<robots::Twist> last;
  EXPECT_EQ(explorer.wait().exit_code, 130);
  while (const auto command = commands.take()) last = command;
  ASSERT_TRUE(last);
  EXPECT_EQ(last->linear.x, 0);
  EXPECT_EQ(last->angular.z, 0);
}

TEST_F(DrivenRobot, IsNotDrivenBesideAnotherProgram) {
  RunningRobot robot(robot_arguments());
  ASSERT_EQ(init(robot.wait_until_ready()).exit_code, 0);
  const Participant participant(robots::domain_of_this_process());
  const robots::Publisher<robots::Twist> joystick(participant, "/cmd_vel", Quality::kDefault);
  const ProgramRun run = run_aisle({"explore", "--connect", connection()});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("another program sends commands on /cmd_vel"));
  ASSERT_EQ(robot.stop(), 0);
  EXPECT_LT(report()["true_path_m"], 0.01);
}

}  // namespace
}  // namespace aisle
