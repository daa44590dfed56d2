#pragma once

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "run_aisle.hpp"
#include "running_robot.hpp"
#include "workplace.hpp"

namespace aisle {

/// A place of its own for a robot in MuJoCo's physics, and for what the program makes of it. Simulated.
class DrivenRobot : public Workplace {
 protected:
  std::vector<std::string> robot_arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {"--world", kWorld,     "--domain",
                                    domain,    "--report", at("robot-report.json"),
                                    "--clock", "--speed",  "5"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// Writes the connection file as a user would, from the measures of the vehicle.
  ProgramRun init(const nlohmann::json& ready, const std::vector<std::string>& more = {}) const {
    const nlohmann::json& footprint = ready["footprint"];
    Arguments arguments = {"connect",
                           "init",
                           "--domain",
                           domain,
                           "--out",
                           connection(),
                           "--footprint",
                           fmt::format("{},{},{}", footprint["front_m"].get<double>(),
                                       footprint["rear_m"].get<double>(), footprint["width_m"].get<double>()),
                           "--speed-max",
                           "0.4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_aisle(arguments);
  }

  nlohmann::json report() const { return nlohmann::json::parse(std::ifstream(at("robot-report.json"))); }
  std::string connection() const { return at("robot.yaml"); }

  static constexpr const char* kWorld = AISLE_SOURCE_DIR "/worlds/l-corridor.yaml";
  const std::string domain = std::to_string(robots::domain_of_this_process());
};

}  // namespace aisle
