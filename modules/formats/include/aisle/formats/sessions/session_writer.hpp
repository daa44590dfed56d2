#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/formats/sessions/session_storage.hpp"

namespace aisle {

/// The picture of a run that may be stored with its session; replacing the session removes it too.
inline constexpr std::string_view kDrivenImage = "driven.svg";

class SessionRecording;

/// A session while it is recorded: a ROS 2 bag, docs/formats/session.md.
///
/// The same messages give the same bytes. A transaction spans less than a second of stamps, and messages of
/// the same stamp are always in one transaction. A process that is killed therefore leaves a readable session
/// that ends less than a second before the last message.
class SessionWriter {
 public:
  /// Begins a session in a new or empty directory. With `force`, an existing session is replaced; a directory
  /// with anything else in it is still a problem.
  static Result<SessionWriter> create(const std::filesystem::path& directory, bool force,
                                      SessionStorage storage = SessionStorage::kSqlite);

  SessionWriter(SessionWriter&&) noexcept;
  SessionWriter& operator=(SessionWriter&&) noexcept;
  /// Closes the session. Call close() first to learn whether that succeeded.
  ~SessionWriter();

  /// Empty on success. After a failure (such as a full disk) nothing more is written, and every call returns
  /// that failure.
  /// @param stamp  0 to 2^62
  Problems write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr);

  /// Ends the session: one file, and the final metadata.yaml. Empty on success.
  Problems close();

  /// Ends the session and removes all its files.
  void discard();

 private:
  SessionWriter(std::filesystem::path directory, std::unique_ptr<SessionRecording> recording);

  Problems keep(Problems problems);

  std::filesystem::path directory_;
  std::unique_ptr<SessionRecording> recording_;  ///< null: moved away, or ended
  std::optional<ros::Stamp_ns> transaction_start_;
  Problems failure_;
};

}  // namespace aisle
