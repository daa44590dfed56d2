#pragma once
/// The file of a trial's missions, one line of JSON each, from which an interrupted trial goes on.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/trials/trial_options.hpp"

namespace aisle {

class TrialJournal {
 public:
  /// Opens `missions.jsonl` in `options.out`, or begins it. Without `--out` nothing is kept.
  /// Problems: it holds another trial's missions, and not `options.force`; another program writes it; it
  /// cannot be read or written.
  static Result<TrialJournal> open(const TrialOptions& options);

  TrialJournal(TrialJournal&& other) noexcept;
  TrialJournal& operator=(TrialJournal&&) = delete;
  ~TrialJournal();

  /// The records that it held when it was opened, by the missions' names.
  const std::map<std::string, nlohmann::ordered_json>& kept() const { return kept_; }
  /// Whether these were run by another build of the program.
  bool is_of_another_build() const { return is_of_another_build_; }
  const std::filesystem::path& path() const { return path_; }
  /// Adds a mission, on the disk when it returns.
  Problems add(const std::string& name, const nlohmann::ordered_json& record);

 private:
  explicit TrialJournal(std::filesystem::path path) : path_(std::move(path)) {}
  Problems read(const nlohmann::ordered_json& header, const std::string& text);
  Problems write(const nlohmann::ordered_json& line) const;

  std::filesystem::path path_;  ///< empty: nothing is kept
  int descriptor_ = -1;
  bool is_of_another_build_ = false;
  std::map<std::string, nlohmann::ordered_json> kept_;
};

}  // namespace aisle
