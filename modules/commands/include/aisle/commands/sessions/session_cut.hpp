#pragma once

#include <filesystem>
#include <optional>

#include "aisle/commands/outcome.hpp"
#include "aisle/formats/sessions/session_storage.hpp"

namespace aisle {

struct SessionCutOptions {
  std::filesystem::path session;
  double from_s = 0;           ///< since the session's first message
  std::optional<double> to_s;  ///< absent: to the end
  std::filesystem::path out;   ///< the new session's directory
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;
};

/// `aisle cut SESSION`: copies a part of a session into a new session, with the latched messages that were
/// sent before it.
Result<Outcome> run_session_cut(const SessionCutOptions& options, Console& console);

}  // namespace aisle
