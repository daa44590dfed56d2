#include "sessions/session_tables.hpp"

#include <fmt/format.h>

#include "sessions/session_metadata.hpp"

namespace aisle {
namespace {

constexpr std::size_t kTopicsMax = 10000;

/// Tables with rows of their own: no views, no virtual tables, no columns that are computed.
Problems check_tables(const sqlite::Database& database) {
  auto tables = database.prepare(
      "SELECT count(*) FROM sqlite_schema AS t WHERE type = 'table' AND name IN ('messages', 'topics') "
      "AND rootpage > 0 AND NOT EXISTS (SELECT * FROM pragma_table_xinfo(t.name) WHERE hidden <> 0)");
  if (!tables) return tables.problems();
  const Result<bool> row = tables->step();
  if (!row) return row.problems();
  if (tables->integer(0) == 2) return {};
  return {{{database.path().string()}, "is not a ROS 2 bag: it needs the tables topics and messages"}};
}

}  // namespace

Result<SessionTables> SessionTables::read(const sqlite::Database& database) {
  if (Problems problems = check_tables(database); !problems.empty()) return problems;
  SessionTables tables(database);
  if (Problems problems = tables.read_topics(); !problems.empty()) return problems;
  return tables;
}

Problems SessionTables::read_topics() {
  // The first bags have no quality of service.
  auto rows = database_->prepare(
      "SELECT id, name, type, serialization_format, offered_qos_profiles FROM topics ORDER BY id");
  if (!rows)
    rows = database_->prepare("SELECT id, name, type, serialization_format, '' FROM topics ORDER BY id");
  if (!rows) return rows.problems();
  while (true) {
    const Result<bool> more = rows->step();
    if (!more) return more.problems();
    if (!*more) return {};
    const std::string name(rows->bytes(1));
    if (const std::string_view format = rows->bytes(3); format != "cdr")
      return {damaged(fmt::format("messages of {} are serialised as '{}'; only cdr is read", name, format))};
    if (topics_.size() == kTopicsMax) return {damaged(fmt::format("has more than {} topics", kTopicsMax))};
    index_of_id_[rows->integer(0)] = topics_.size();
    ids_.push_back(rows->integer(0));
    topics_.push_back({name, std::string(rows->bytes(2)), is_latched(std::string(rows->bytes(4)))});
  }
}

Result<std::size_t> SessionTables::index_of(std::int64_t topic_id) const {
  if (const auto found = index_of_id_.find(topic_id); found != index_of_id_.end()) return found->second;
  return damaged(fmt::format("has a message of topic {}, which it does not list", topic_id));
}

Result<ros::Stamp_ns> SessionTables::stamp_of(std::int64_t timestamp) const {
  if (timestamp >= 0 && timestamp < ros::kStampEnd_ns) return timestamp;
  return damaged(fmt::format("has a message with the stamp {} ns; 0 to 2^62 is read", timestamp));
}

}  // namespace aisle
