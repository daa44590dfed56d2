#include <map>
#include <string>
#include <utility>

#include "sessions/session_files.hpp"
#include "sessions/session_recording.hpp"
#include "sessions/sqlite.hpp"

namespace aisle {
namespace {

/// rosbag2's tables as created by ROS 2 Humble.
constexpr const char* kTables =
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT "
    "NULL);"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
    " data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
    "INSERT INTO schema(schema_version, ros_distro) VALUES (3, 'humble')";

/// The open database, its statements, and the current transaction.
class SqliteRecording final : public SessionRecording {
 public:
  SqliteRecording(std::filesystem::path directory, sqlite::Database database)
      : directory_(std::move(directory)), database_(std::move(database)) {}

  Problems begin() {
    if (Problems problems = database_.run(kTables); !problems.empty()) return problems;
    auto topic = database_.prepare("INSERT INTO topics VALUES (?, ?, ?, 'cdr', ?)");
    if (!topic) return topic.problems();
    auto message = database_.prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)");
    if (!message) return message.problems();
    insert_topic_ = std::move(*topic);
    insert_message_ = std::move(*message);
    return {};
  }

  Problems write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) override {
    if (!std::exchange(in_transaction_, true)) {
      if (Problems problems = database_.run("BEGIN"); !problems.empty()) return problems;
    }
    const Result<std::int64_t> id = id_of(topic);
    if (!id) return id.problems();
    insert_message_->bind(0, *id);
    insert_message_->bind(1, stamp);
    insert_message_->bind_blob(2, cdr);
    return insert_message_->run();
  }

  Problems commit() override {
    return std::exchange(in_transaction_, false) ? database_.run("COMMIT") : Problems{};
  }

  Problems finish() override {
    insert_topic_.reset();
    insert_message_.reset();
    return finish_database(directory_, database_);
  }

 private:
  Result<std::int64_t> id_of(const SessionTopic& topic) {
    if (const auto known = topic_ids_.find(topic.name); known != topic_ids_.end()) return known->second;
    const auto id = static_cast<std::int64_t>(topic_ids_.size() + 1);
    const std::string quality = quality_of_service(topic.latched);
    insert_topic_->bind(0, id);
    insert_topic_->bind_text(1, topic.name);
    insert_topic_->bind_text(2, topic.type);
    insert_topic_->bind_text(3, quality);
    if (Problems problems = insert_topic_->run(); !problems.empty()) return problems;
    topic_ids_[topic.name] = id;
    return id;
  }

  std::filesystem::path directory_;
  sqlite::Database database_;
  std::optional<sqlite::Statement> insert_topic_;
  std::optional<sqlite::Statement> insert_message_;
  std::map<std::string, std::int64_t> topic_ids_;
  bool in_transaction_ = false;
};

}  // namespace

Result<std::unique_ptr<SessionRecording>> record_sqlite(const std::filesystem::path& directory) {
  auto database = sqlite::Database::create(storage_path(directory, SessionStorage::kSqlite));
  if (!database) return database.problems();
  auto recording = std::make_unique<SqliteRecording>(directory, std::move(*database));
  if (Problems problems = recording->begin(); !problems.empty()) return problems;
  return std::unique_ptr<SessionRecording>(std::move(recording));
}

}  // namespace aisle
