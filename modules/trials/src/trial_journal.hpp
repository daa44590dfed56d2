#pragma once
/// The file of a trial's missions, one line of JSON each, from which an interrupted trial goes on, and
/// through which several processes share one trial.

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/trials/trial_options.hpp"
#include "shared_file.hpp"

namespace aisle {

/// What becomes of a process's wish to run a mission.
enum class MissionClaim {
  kGranted,  ///< nobody else runs it from here on
  kRefused,  ///< another process runs it
  kEnded     ///< it has been run
};

class TrialJournal {
 public:
  using Records = std::map<std::string, nlohmann::ordered_json>;  ///< by the missions' names

  /// Opens `missions.jsonl` in `options.out`; it is there once a mission has ended. Without `--out` nothing
  /// is kept. Problems: it holds another trial's missions, and not `options.force`; that is given and another
  /// process has the journal open; it cannot be read, written or locked.
  static Result<TrialJournal> open(const TrialOptions& options);

  // NOLINTNEXTLINE(bugprone-exception-escape): moving JSON throws only where its own invariant is broken
  TrialJournal(TrialJournal&& other) = default;
  TrialJournal& operator=(TrialJournal&&) = delete;
  ~TrialJournal();

  /// Of all missions that have ended, whoever ran them, as far as this process has read.
  const Records& records() const { return records_; }
  /// What missions died of since the journal was opened.
  const std::map<std::string, std::string>& deaths() const { return deaths_; }
  /// How many records it held when it was opened.
  std::size_t kept() const { return kept_; }
  /// Whether some were run by another build of the program.
  bool is_of_another_build() const { return is_of_another_build_; }
  std::filesystem::path path() const { return file_ ? file_->path() : std::filesystem::path(); }

  /// Asks for a mission. A claim ends with the mission or with this process.
  Result<MissionClaim> claim(const std::string& name);
  /// Adds a mission that this process has claimed; it is on the disk when this returns.
  Problems add(const std::string& name, const nlohmann::ordered_json& record);
  /// Adds that a claimed mission's process died, so that none of the others tries it as well.
  Problems add_death(const std::string& name, const std::string& died_of);

 private:
  TrialJournal() = default;  // NOLINT(bugprone-exception-escape): making empty JSON throws nothing
  void leave();
  Problems enter(const TrialOptions& options);
  Problems read_news();
  Problems take_line(const std::string& line);
  Problems take_header(const nlohmann::ordered_json& said);
  Problems append(const std::string& name, const nlohmann::ordered_json& line);
  bool has_ended(const std::string& name) const { return records_.contains(name) || deaths_.contains(name); }

  std::optional<SharedFile> file_;  ///< none: nothing is kept
  nlohmann::ordered_json header_;   ///< its first line: which trial, by which build
  off_t read_bytes_ = 0;            ///< of whole lines
  long read_lines_ = 0;
  bool is_entered_ = false;  ///< deaths of before are over: these missions are tried again
  bool is_of_another_build_ = false;
  std::size_t kept_ = 0;
  Records records_;
  std::map<std::string, std::string> deaths_;
};

}  // namespace aisle
