#pragma once
/// The tables of a bag, as far as they can be believed.

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
  /// A database without rosbag2's tables, or with views of their names, which could be endless work, is a
  /// problem.
  static Result<SessionTables> read(const sqlite::Database& database);

  const std::vector<SessionTopic>& topics() const { return topics_; }

  /// The topic that a message's topic_id stands for.
  Result<std::size_t> index_of(std::int64_t topic_id) const;

  /// A message's timestamp, if it is one.
  Result<ros::Stamp_ns> stamp_of(std::int64_t timestamp) const;

 private:
  explicit SessionTables(const sqlite::Database& database) : database_(&database) {}

  Problems read_topics();
  Problem damaged(std::string what) const { return {{database_->path().string()}, std::move(what)}; }

  const sqlite::Database* database_;
  std::vector<SessionTopic> topics_;
  std::map<std::int64_t, std::size_t> index_of_id_;
};

}  // namespace aisle
