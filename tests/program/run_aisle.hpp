#pragma once
/// Starts the real program, as a user or a script would.

#include <sys/types.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace aisle {

using Arguments = std::vector<std::string>;

/// The result of a run of the program.
struct ProgramRun {
  int exit_code = -1;  ///< -1 if killed by a signal
  std::string out;     ///< standard output
  std::string err;     ///< standard error

  /// The one JSON object on standard output; throws if there is anything else.
  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// The program while it runs. The destructor waits for its end.
class RunningAisle {
 public:
  /// @param in  becomes its standard input; below 0: it has none
  explicit RunningAisle(const Arguments& arguments, int in = -1);
  RunningAisle(const RunningAisle&) = delete;
  RunningAisle& operator=(const RunningAisle&) = delete;
  ~RunningAisle();

  void signal(int number) const;
  /// Its standard error so far.
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
