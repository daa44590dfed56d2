#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_message.hpp"

namespace aisle {

class SessionSource;

/// Reads a ROS 2 bag in SQLite or MCAP, message by message. If the recording of a database was killed,
/// opening finishes the session first: it merges the journal into the database and corrects metadata.yaml. An
/// MCAP file without its end is read as far as it goes, but for its last stamp. A session that is still being
/// recorded is read up to its last commit.
class SessionReader {
 public:
  struct Message {
    const SessionTopic& topic;
    ros::Stamp_ns stamp = 0;  ///< 0 to 2^62
    std::string_view cdr;     ///< valid until the next call
  };

  /// Bags of other layouts (compressed as a whole, several files) are problems that say which layout is read.
  static Result<SessionReader> open(const std::filesystem::path& directory);

  SessionReader(SessionReader&&) noexcept;
  SessionReader& operator=(SessionReader&&) noexcept;
  ~SessionReader();

  /// In the order in which they were first recorded.
  const std::vector<SessionTopic>& topics() const;

  /// The session's file, to name it in problems with the content of messages.
  const std::filesystem::path& database() const;

  /// The next message, ordered by stamp; messages with equal stamps come in recording order. An MCAP file in
  /// another order is a problem.
  /// @return nullopt after the last
  Result<std::optional<Message>> next();

  /// The bytes of a topic's first message. Does not affect next().
  /// @return nullopt if there is none
  Result<std::optional<std::string>> first_of(const std::string& topic) const;

 private:
  explicit SessionReader(std::unique_ptr<SessionSource> source);

  std::unique_ptr<SessionSource> source_;
};

}  // namespace aisle
