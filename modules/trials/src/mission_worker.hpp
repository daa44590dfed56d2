#pragma once
/// A process that runs missions one after the other: one that dies takes nothing with it but its mission.

#include <sys/types.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "aisle/core/result.hpp"
#include "mission_runs.hpp"

namespace aisle {

/// What a worker says of a mission that has ended: a record, problems, or why it died.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON throws only where its own invariant is broken
struct WorkerAnswer {
  nlohmann::ordered_json record;  ///< null: there is none
  Problems problems;
  std::string died_of;  ///< empty: it lived to its end
};

class MissionWorker {
 public:
  /// Starts the process. The caller must have no other threads.
  static Result<MissionWorker> start(const TrialMissions& missions);

  MissionWorker(MissionWorker&& other) noexcept;
  MissionWorker& operator=(MissionWorker&& other) noexcept;
  /// Kills the process.
  ~MissionWorker();

  /// What it works on; nullopt: it waits for a mission.
  std::optional<std::size_t> mission() const { return mission_; }
  /// Hands it a mission when it waits.
  void begin(std::size_t mission);
  /// Readable when it has said something.
  int descriptor() const { return socket_; }
  /// Takes what it has said, without waiting for more; its warnings go to the console.
  /// @return the mission's end, if it has ended
  std::optional<WorkerAnswer> take(const Console& console);
  bool is_dead() const { return process_ < 0; }

 private:
  MissionWorker(pid_t process, int socket) : process_(process), socket_(socket) {}

  std::optional<WorkerAnswer> said(const std::string& line, const Console& console);
  std::string bury();

  pid_t process_;  ///< -1: moved from, or dead
  int socket_;     ///< -1: moved from
  std::optional<std::size_t> mission_;
  std::string bytes_;  ///< of a line that has not come whole
};

}  // namespace aisle
