/// The program drives a robot of another make: Enki's marXbot, simulated.
#include <gmock/gmock.h>

#include <fstream>

#include "run_aisle.hpp"
#include "running_robot.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

class EnkiRobot : public Workplace {};

TEST_F(EnkiRobot, IsTriedAndExplores) {
  const std::string domain = std::to_string(robots::domain_of_this_process());
  robots::RunningRobot robot({"--world", AISLE_SOURCE_DIR "/worlds/l-corridor.yaml", "--domain", domain,
                              "--speed", "3", "--report", at("report.json")},
                             ENKI_ROBOT);
  robot.wait_until_ready();
  const ProgramRun written = run_aisle({"connect", "init", "--domain", domain, "--out", at("robot.yaml"),
                                        "--footprint", "0.09,0.09,0.18", "--speed-max", "0.3"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const ProgramRun tried = run_aisle({"connect", "try", "--connect", at("robot.yaml")});
  ASSERT_EQ(tried.exit_code, 0) << tried.out << tried.err;
  const ProgramRun explored = run_aisle({"explore", "--connect", at("robot.yaml"), "--json"});
  EXPECT_EQ(explored.exit_code, 0) << explored.out << explored.err;
  ASSERT_EQ(robot.stop(), 0);
  const nlohmann::json report = nlohmann::json::parse(std::ifstream(at("report.json")));
  EXPECT_LT(report["off_home_m"], 0.25) << "Enki's scanner sees slanted walls up to 1 % too near";
}

}  // namespace
}  // namespace aisle
