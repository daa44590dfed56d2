#pragma once

#include <filesystem>
#include <string>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct SessionReplayOptions {
  std::filesystem::path session;
  std::string navigator;  ///< name; empty: the one that drove
};

/// `aisle replay SESSION`: runs a navigator on the recorded observations and compares every decision with the
/// recorded one, bit for bit. The outcome is ok if all are equal.
Result<Outcome> run_session_replay(const SessionReplayOptions& options, Console& console);

}  // namespace aisle
