#pragma once
/// Starts the real program, as a user or a script would.

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace aisle {

using Arguments = std::vector<std::string>;

/// How a run of the program ended.
struct ProgramRun {
  int exit_code = -1;  ///< -1: killed by a signal
  std::string out;     ///< standard output
  std::string err;     ///< standard error

  /// The one JSON object on standard output; throws where there is anything else.
  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// The program at work. The destructor waits for its end.
class RunningAisle {
 public:
  explicit RunningAisle(const Arguments& arguments);
  RunningAisle(const RunningAisle&) = delete;
  RunningAisle& operator=(const RunningAisle&) = delete;
  ~RunningAisle();

  void signal(int number) const;
  /// What it has said on standard error by now.
  std::string error_so_far() const;
  ProgramRun wait();

 private:
  pid_t process_ = 0;
  int out_;
  int err_;
};

/// Runs the program to its end.
ProgramRun run_aisle(const Arguments& arguments);

}  // namespace aisle
