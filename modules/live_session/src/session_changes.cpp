#include "session_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "live_arguments.hpp"
#include "live_request_handler.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

Problem session_problem(const char* key, const std::string& what) {
  return {{"", 0, key}, what};
}

bool holds_folders(const fs::path& session) {
  std::error_code error;
  const fs::directory_iterator entries(session, error);
  return std::any_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    std::error_code unknown;
    return entry.is_directory(unknown) && !entry.is_symlink(unknown);
  });
}

}  // namespace

Problems rename_session(const fs::path& sessions, const nlohmann::json& arguments) {
  LiveArguments read(arguments);
  const std::string session = read.needed_name("session"), to = read.needed_name("to");
  if (Problems problems = read.problems(); !problems.empty()) return problems;
  const auto present = session_named(sessions, {{"session", session}});
  if (!present) return present.problems();
  std::error_code error;
  if (fs::exists(sessions / to, error))
    return {session_problem("to", fmt::format("'{}' is there already", to))};
  fs::rename(*present, sessions / to, error);
  if (error) return {session_problem("session", "cannot be renamed: " + error.message())};
  return {};
}

Problems delete_session(const fs::path& sessions, const nlohmann::json& arguments) {
  const auto session = session_named(sessions, arguments);
  if (!session) return session.problems();
  if (holds_folders(*session))
    return {session_problem("session", "holds folders that are no part of a session; it was not deleted")};
  std::error_code error;
  fs::remove_all(*session, error);
  if (error) return {session_problem("session", "cannot be deleted: " + error.message())};
  return {};
}

}  // namespace aisle
