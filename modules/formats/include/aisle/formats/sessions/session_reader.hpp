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

/// A ROS 2 bag in rosbag2's SQLite layout, message by message. A session whose recording was killed is
/// finished first: its journal is taken into the database and its metadata.yaml corrected. One that is still
/// being recorded is read as far as it is kept.
class SessionReader {
 public:
  struct Message {
    const SessionTopic& topic;
    ros::Stamp_ns stamp = 0;  ///< 0 to 2^62
    std::string_view cdr;     ///< valid until the next call
  };

  /// Bags of other layouts (MCAP, compressed, several files) are problems that say what would be read.
  static Result<SessionReader> open(const std::filesystem::path& directory);

  SessionReader(SessionReader&&) noexcept;
  SessionReader& operator=(SessionReader&&) noexcept;
  ~SessionReader();

  /// In the order in which they were first recorded.
  const std::vector<SessionTopic>& topics() const;

  /// The database, for problems with what its messages say.
  const std::filesystem::path& database() const;

  /// The next message: by stamp, equal stamps as they were recorded.
  /// @return nullopt after the last
  Result<std::optional<Message>> next();

  /// The bytes of a topic's first message; does not disturb next().
  /// @return nullopt if there is none
  Result<std::optional<std::string>> first_of(const std::string& topic) const;

 private:
  class Source;

  explicit SessionReader(std::unique_ptr<Source> source);

  std::unique_ptr<Source> source_;
};

}  // namespace aisle
