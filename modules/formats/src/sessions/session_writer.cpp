#include "aisle/formats/sessions/session_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "aisle/formats/whole_file.hpp"
#include "sessions/session_files.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr ros::Stamp_ns kTransaction_ns = 1'000'000'000;

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

bool is_name(const std::string& text) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '/';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_allowed);
}

}  // namespace

/// The open database, its statements, and the current transaction.
class SessionWriter::Recording {
 public:
  Recording(fs::path directory, sqlite::Database database)
      : directory_(std::move(directory)), database_(std::move(database)) {}

  Problems begin();
  Problems write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr);
  Problems close();
  const fs::path& directory() const { return directory_; }

 private:
  Problems keep_transaction_short(ros::Stamp_ns stamp);
  Result<std::int64_t> id_of(const SessionTopic& topic);
  Problems insert(std::int64_t topic_id, ros::Stamp_ns stamp, std::string_view cdr);
  Problems commit();
  Problems failed(Problems problems);

  fs::path directory_;
  sqlite::Database database_;
  std::optional<sqlite::Statement> insert_topic_;
  std::optional<sqlite::Statement> insert_message_;
  std::map<std::string, std::int64_t> topic_ids_;
  std::optional<ros::Stamp_ns> transaction_start_;
  Problems failure_;
  bool is_closed_ = false;
};

Problems SessionWriter::Recording::begin() {
  if (Problems problems = database_.run(kTables); !problems.empty()) return problems;
  auto topic = database_.prepare("INSERT INTO topics VALUES (?, ?, ?, 'cdr', ?)");
  if (!topic) return topic.problems();
  auto message = database_.prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)");
  if (!message) return message.problems();
  insert_topic_ = std::move(*topic);
  insert_message_ = std::move(*message);
  return {};
}

Problems SessionWriter::Recording::write(const SessionTopic& topic, ros::Stamp_ns stamp,
                                         std::string_view cdr) {
  if (!failure_.empty()) return failure_;
  if (Problems problems = keep_transaction_short(stamp); !problems.empty()) return failed(problems);
  const Result<std::int64_t> id = id_of(topic);
  if (!id) return failed(id.problems());
  if (Problems problems = insert(*id, stamp, cdr); !problems.empty()) return failed(problems);
  return {};
}

/// A transaction ends before the first message that is a second later than its first one, so messages of one
/// stamp are never split.
Problems SessionWriter::Recording::keep_transaction_short(ros::Stamp_ns stamp) {
  if (transaction_start_ && stamp < *transaction_start_ + kTransaction_ns) return {};
  if (Problems problems = commit(); !problems.empty()) return problems;
  transaction_start_ = stamp;
  return database_.run("BEGIN");
}

Problems SessionWriter::Recording::commit() {
  if (!transaction_start_) return {};
  transaction_start_.reset();
  return database_.run("COMMIT");
}

Result<std::int64_t> SessionWriter::Recording::id_of(const SessionTopic& topic) {
  if (const auto known = topic_ids_.find(topic.name); known != topic_ids_.end()) return known->second;
  if (!is_name(topic.name) || !is_name(topic.type)) {
    return Problem{{database_.path().string()},
                   fmt::format("'{}' of type '{}' is no topic", topic.name, topic.type)};
  }
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

Problems SessionWriter::Recording::insert(std::int64_t topic_id, ros::Stamp_ns stamp, std::string_view cdr) {
  insert_message_->bind(0, topic_id);
  insert_message_->bind(1, stamp);
  insert_message_->bind_blob(2, cdr);
  return insert_message_->run();
}

Problems SessionWriter::Recording::failed(Problems problems) {
  failure_ = std::move(problems);
  return failure_;
}

Problems SessionWriter::Recording::close() {
  if (is_closed_) return {};
  is_closed_ = true;
  Problems problems = failure_.empty() ? commit() : failure_;
  insert_topic_.reset();
  insert_message_.reset();
  if (problems.empty()) problems = finish_session(directory_, database_);
  return problems;
}

SessionWriter::SessionWriter(std::unique_ptr<Recording> recording) : recording_(std::move(recording)) {}
SessionWriter::SessionWriter(SessionWriter&&) noexcept = default;
SessionWriter& SessionWriter::operator=(SessionWriter&&) noexcept = default;

SessionWriter::~SessionWriter() {
  if (recording_) (void)recording_->close();
}

Result<SessionWriter> SessionWriter::create(const fs::path& directory, bool force) {
  if (Problems problems = prepare_directory(directory, force); !problems.empty()) return problems;
  const fs::path path = database_path(directory);
  const SessionMetadata nothing_yet{.database_name = path.filename().string()};
  if (Problems problems = write_whole_file(directory / kMetadataName, metadata_yaml(nothing_yet));
      !problems.empty())
    return problems;
  Result<sqlite::Database> database = sqlite::Database::create(path);
  if (!database) return database.problems();
  auto recording = std::make_unique<Recording>(directory, std::move(*database));
  if (Problems problems = recording->begin(); !problems.empty()) return problems;
  return SessionWriter(std::move(recording));
}

Problems SessionWriter::write(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  return recording_->write(topic, stamp, cdr);
}

Problems SessionWriter::close() {
  return recording_->close();
}

void SessionWriter::discard() {
  const fs::path directory = recording_->directory();
  recording_.reset();
  remove_session(directory);
}

}  // namespace aisle
