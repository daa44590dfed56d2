#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace aisle {

/// The list of the sessions in a folder. What was read of a session is kept, also in a hidden file of the
/// folder, until the session changes, so that a long list is quick.
class SessionIndex {
 public:
  /// @param folder  empty: there are no sessions
  explicit SessionIndex(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// One row for each session, sorted by name: docs/reference/live-server.md. What is no session is left out.
  nlohmann::ordered_json rows();

 private:
  // NOLINTNEXTLINE(bugprone-exception-escape): moving JSON throws only where its own invariant is broken
  struct Entry {
    std::string state;           ///< of the session's files when it was read
    nlohmann::ordered_json row;  ///< null: cannot be read
  };

  void load();
  void save() const;

  std::filesystem::path folder_;
  std::map<std::string, Entry> entries_;
  bool is_loaded_ = false;
};

}  // namespace aisle
