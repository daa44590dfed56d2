#pragma once

#include <filesystem>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct SessionInfoOptions {
  std::filesystem::path input;  ///< a session, a bag or a laser log
};

/// `aisle info INPUT`: what a session contains; of a recording that aisle did not make, what it could serve
/// for.
Result<Outcome> run_session_info(const SessionInfoOptions& options, Console& console);

}  // namespace aisle
