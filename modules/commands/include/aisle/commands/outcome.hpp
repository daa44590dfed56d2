#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/message_sink.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// The result of a verb, printed as text for people or as one JSON object for programs.
struct Outcome {
  std::string verb;
  bool ok = true;  ///< false: the mission failed (exit code 1); the figures are valid all the same
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();
  std::map<std::string, std::string> files;  ///< written files: role -> path
  std::string text;                          ///< for people
  Problems problems = {};                    ///< why it was refused; empty: it was not
  bool is_printed_elsewhere = false;         ///< by another of the processes that share the work
};

/// [{"where": ..., "what": ...}]: how every verb reports warnings and problems.
nlohmann::ordered_json warnings_json(const Problems& warnings);

/// {"verb": ..., "ok": ..., "figures": {...}, "files": {...}} on one line; "problems" if there are any.
std::string to_json(const Outcome& outcome);

/// What a verb may use of its environment.
struct Console {
  Progress& progress;
  std::function<void(const std::string&)> warn;
  MessageSink* watcher = nullptr;  ///< receives what a mission records; null: nobody watches
  /// How people changed the goals of `go` since the last cycle, when it is asked; null: nobody can.
  std::function<std::vector<GoalChange>()> goal_changes = nullptr;
};

/// Says each of them as a warning.
void warn_of(const Problems& warnings, const Console& console);

}  // namespace aisle
