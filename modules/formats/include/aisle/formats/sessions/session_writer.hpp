#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_message.hpp"

namespace aisle {

/// The image of a run that may lie beside its session, and is replaced with it.
inline constexpr std::string_view kDrivenImage = "driven.svg";

/// A session while it is recorded: a ROS 2 bag in rosbag2's SQLite layout, docs/formats/session.md.
///
/// The same messages give the same bytes. Messages are kept in transactions of less than a second by their
/// stamps, and messages of the same stamp always in one: a process that is killed leaves a session that opens
/// and ends less than a second before the last message.
class SessionWriter {
 public:
  /// Begins a session in a directory that is new or empty. With `force` a session that is there already is
  /// replaced; a directory with anything else in it is a problem all the same.
  static Result<SessionWriter> create(const std::filesystem::path& directory, bool force);

  SessionWriter(SessionWriter&&) noexcept;
  SessionWriter& operator=(SessionWriter&&) noexcept;
  /// Closes; who wants to know whether that succeeded calls close() before.
  ~SessionWriter();

  /// Empty on success. After a failure (the disk is full) nothing more is written, and every call returns
  /// that failure.
  /// @param stamp_ns  0 to 2^62
  Problems write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr);

  /// Ends the session: one database file without a journal, and the final metadata.yaml. Empty on success.
  Problems close();

  /// Ends the session without a trace of it.
  void discard();

 private:
  class Recording;

  explicit SessionWriter(std::unique_ptr<Recording> recording);

  std::unique_ptr<Recording> recording_;
};

}  // namespace aisle
