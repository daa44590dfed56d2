#pragma once

#include <filesystem>
#include <string>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct SessionReplayOptions {
  std::filesystem::path session;
  std::string navigator;  ///< by name; empty: the one that drove
};

/// `aisle replay SESSION`: lets a navigator decide on the recorded observations and compares every decision
/// with the recorded one, bit for bit. The outcome is ok when all are equal.
Result<Outcome> run_session_replay(const SessionReplayOptions& options, Console& console);

}  // namespace aisle
