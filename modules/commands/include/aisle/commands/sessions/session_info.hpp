#pragma once

#include <filesystem>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct SessionInfoOptions {
  std::filesystem::path session;
};

/// `aisle info SESSION`: what a session contains. Reads any ROS 2 bag in the SQLite layout.
Result<Outcome> run_session_info(const SessionInfoOptions& options);

}  // namespace aisle
