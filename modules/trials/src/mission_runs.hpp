#pragma once
/// The missions of a trial: in processes of their own, several at a time, and kept as they end.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/core/result.hpp"
#include "aisle/trials/trial_options.hpp"

namespace aisle {

/// What there is to run. A mission's record is a JSON object with all that the trial's figures need of it,
/// whoever ran it and whenever, and "ok": whether it went well.
struct TrialMissions {
  std::size_t count = 0;
  std::function<std::string(std::size_t mission)> name;  ///< unique in the trial: "seed 301"
  std::function<Result<nlohmann::ordered_json>(std::size_t mission, Console&)> run;
};

/// One mission for each of the trial's seeds.
TrialMissions per_seed(const TrialOptions& options,
                       std::function<Result<nlohmann::ordered_json>(std::uint64_t seed, Console&)> run);

/// What came of them.
struct TrialRecords {
  /// Of the missions that ended, with their names, in the trial's order.
  std::vector<std::pair<std::string, nlohmann::ordered_json>> records;
  std::vector<std::string> failed;  ///< names of those that did not go well
  std::vector<std::string> died;    ///< names of those whose process did not live to its end, and why
  std::size_t wanted = 0;
  bool was_interrupted = false;

  /// Adds to a trial's outcome what failed, died or was not run, and the command that shows it.
  void report(const TrialOptions& options, Outcome& outcome) const;
};

/// Runs all missions that `options.out` does not hold already, `options.jobs` at a time. A mission that dies
/// costs itself alone. Interrupted by the progress, it returns what has ended. Problems: what a mission
/// cannot begin without; the journal cannot be read or written.
Result<TrialRecords> run_missions(const TrialOptions& options, const TrialMissions& missions,
                                  Console& console);

/// A method's figures over its missions, and these. The outcome is ok if all that ended went well.
struct TrialResult {
  Outcome outcome;
  TrialRecords records;
};

}  // namespace aisle
