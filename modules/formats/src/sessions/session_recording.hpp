#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_message.hpp"

namespace aisle {

/// The file of a session while it is recorded. After a failure nothing more is called.
class SessionRecording {
 public:
  virtual ~SessionRecording() = default;

  /// Into the transaction at hand.
  virtual Problems write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) = 0;
  /// Ends the transaction: whatever happens to the process, it is kept as a whole from now on.
  virtual Problems commit() = 0;
  /// The file's end and the final metadata.yaml, after the last commit.
  virtual Problems finish() = 0;
};

/// rosbag2's SQLite layout. The directory is prepared, and holds the metadata of an empty session.
Result<std::unique_ptr<SessionRecording>> record_sqlite(const std::filesystem::path& directory);

/// MCAP. Each transaction is a chunk, written at once.
Result<std::unique_ptr<SessionRecording>> record_mcap(const std::filesystem::path& directory);

}  // namespace aisle
