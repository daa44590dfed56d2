#pragma once
/// The tables of a bag, after checks that they can be trusted.

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_message.hpp"
#include "sessions/sqlite.hpp"

namespace aisle {

/// The topics of a bag; `database` must outlive it.
class SessionTables {
 public:
  /// A database without rosbag2's tables is a problem. So is one with views of their names, which could take
  /// endless time to read.
  static Result<SessionTables> read(const sqlite::Database& database);

  const std::vector<SessionTopic>& topics() const { return topics_; }

  /// The topic_id of a topic.
  std::int64_t id(std::size_t topic) const { return ids_[topic]; }

  /// The index of the topic with this topic_id.
  Result<std::size_t> index_of(std::int64_t topic_id) const;

  /// The message's timestamp; a problem if out of range.
  Result<ros::Stamp_ns> stamp_of(std::int64_t timestamp) const;

 private:
  explicit SessionTables(const sqlite::Database& database) : database_(&database) {}

  Problems read_topics();
  Problem damaged(std::string what) const { return {{database_->path().string()}, std::move(what)}; }

  const sqlite::Database* database_;
  std::vector<SessionTopic> topics_;
  std::vector<std::int64_t> ids_;
  std::map<std::int64_t, std::size_t> index_of_id_;
};

}  // namespace aisle
