#pragma once
/// What `aisle connect check` says of a robot.

#include <nlohmann/json.hpp>
#include <string>

#include "aisle/connection/robot_check.hpp"

namespace aisle {

nlohmann::ordered_json figures_of(const RobotCheck& check);
std::string check_text(const RobotCheck& check);

}  // namespace aisle
