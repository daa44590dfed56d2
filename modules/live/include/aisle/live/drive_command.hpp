#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/clock.hpp"
#include "aisle/vehicle/command.hpp"

namespace aisle {

/// What the driving client sends on the topic /drive.
struct DriveCommand {
  std::string lease;
  std::uint64_t sequence = 0;
  double age_s = 0;  ///< time since it was sent
  Command command;
};

/// @return nullopt unless all fields are present, finite and in range
std::optional<DriveCommand> parse_drive_command(std::string_view json);

/// Hands the newest drive command from the server's thread to the mission's thread.
class DriveInbox {
 public:
  explicit DriveInbox(const Clock& clock) : clock_(clock) {}

  /// A new lease: the waiting command is dropped, and sequence numbers may start again.
  void begin_lease();

  /// @return false if its sequence number is not greater than all before
  bool put(const DriveCommand& command);

  /// The newest command since the last call, with its current age; nullopt if none has come.
  std::optional<DriveCommand> take();

 private:
  const Clock& clock_;
  std::mutex mutex_;
  std::optional<DriveCommand> newest_;
  double put_s_ = 0;
  std::optional<std::uint64_t> last_sequence_;
};

}  // namespace aisle
