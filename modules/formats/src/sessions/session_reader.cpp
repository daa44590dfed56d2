#include "aisle/formats/sessions/session_reader.hpp"

#include <utility>

#include "sessions/session_files.hpp"
#include "sessions/session_tables.hpp"

namespace aisle {
namespace fs = std::filesystem;

/// The open database with its topics and the rows not yet read.
class SessionReader::Source {
 public:
  explicit Source(sqlite::Database database) : database_(std::move(database)) {}

  Problems begin();
  const std::vector<SessionTopic>& topics() const { return tables_->topics(); }
  const fs::path& path() const { return database_.path(); }
  Result<std::optional<Message>> next();
  Result<std::optional<std::string>> first_of(const std::string& topic) const;

 private:
  sqlite::Database database_;
  std::optional<SessionTables> tables_;
  std::optional<sqlite::Statement> rows_;
};

Problems SessionReader::Source::begin() {
  auto tables = SessionTables::read(database_);
  if (!tables) return tables.problems();
  tables_ = std::move(*tables);
  auto rows = database_.prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
  if (!rows) return rows.problems();
  rows_ = std::move(*rows);
  return {};
}

Result<std::optional<SessionReader::Message>> SessionReader::Source::next() {
  const Result<bool> more = rows_->step();
  if (!more) return more.problems();
  if (!*more) return std::optional<Message>();
  const auto topic = tables_->index_of(rows_->integer(0));
  if (!topic) return topic.problems();
  const auto stamp = tables_->stamp_of(rows_->integer(1));
  if (!stamp) return stamp.problems();
  return std::optional(Message{topics()[*topic], *stamp, rows_->bytes(2)});
}

Result<std::optional<std::string>> SessionReader::Source::first_of(const std::string& topic) const {
  auto rows = database_.prepare(
      "SELECT data FROM messages JOIN topics ON topics.id = topic_id WHERE name = ? ORDER BY timestamp, "
      "messages.id LIMIT 1");
  if (!rows) return rows.problems();
  rows->bind_text(0, topic);
  const Result<bool> found = rows->step();
  if (!found) return found.problems();
  if (!*found) return std::optional<std::string>();
  return std::optional(std::string(rows->bytes(0)));
}

SessionReader::SessionReader(std::unique_ptr<Source> source) : source_(std::move(source)) {}
SessionReader::SessionReader(SessionReader&&) noexcept = default;
SessionReader& SessionReader::operator=(SessionReader&&) noexcept = default;
SessionReader::~SessionReader() = default;

Result<SessionReader> SessionReader::open(const fs::path& directory) {
  Result<sqlite::Database> database = open_session(directory);
  if (!database) return database.problems();
  auto source = std::make_unique<Source>(std::move(*database));
  if (Problems problems = source->begin(); !problems.empty()) return problems;
  return SessionReader(std::move(source));
}

const std::vector<SessionTopic>& SessionReader::topics() const {
  return source_->topics();
}

const fs::path& SessionReader::database() const {
  return source_->path();
}

Result<std::optional<SessionReader::Message>> SessionReader::next() {
  return source_->next();
}

Result<std::optional<std::string>> SessionReader::first_of(const std::string& topic) const {
  return source_->first_of(topic);
}

}  // namespace aisle
