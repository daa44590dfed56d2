#include <utility>

#include "sessions/session_files.hpp"
#include "sessions/session_source.hpp"
#include "sessions/session_tables.hpp"

namespace aisle {
namespace {

/// The open database with its topics and the rows not yet read.
class SqliteSession final : public SessionSource {
 public:
  explicit SqliteSession(sqlite::Database database)
      : SessionSource(database.path()), database_(std::move(database)) {}

  Problems begin() {
    auto tables = SessionTables::read(database_);
    if (!tables) return tables.problems();
    tables_ = std::move(*tables);
    return {};
  }

  const std::vector<SessionTopic>& topics() const override { return tables_->topics(); }
  Result<std::optional<SessionReader::Message>> next() override;
  Result<std::optional<std::string>> first_of(const std::string& topic) const override;
  Result<std::optional<Row>> next_row() override;

 private:
  /// The row's topic and stamp; nullopt after the last row.
  Result<std::optional<Row>> step(std::optional<sqlite::Statement>& rows, const char* query);

  sqlite::Database database_;
  std::optional<SessionTables> tables_;
  std::optional<sqlite::Statement> rows_, sizes_;
};

Result<std::optional<SessionSource::Row>> SqliteSession::step(std::optional<sqlite::Statement>& rows,
                                                              const char* query) {
  if (!rows) {
    auto prepared = database_.prepare(query);
    if (!prepared) return prepared.problems();
    rows = std::move(*prepared);
  }
  const Result<bool> more = rows->step();
  if (!more) return more.problems();
  if (!*more) return std::optional<Row>();
  const auto topic = tables_->index_of(rows->integer(0));
  if (!topic) return topic.problems();
  const auto stamp = tables_->stamp_of(rows->integer(1));
  if (!stamp) return stamp.problems();
  return std::optional(Row{*topic, *stamp});
}

Result<std::optional<SessionReader::Message>> SqliteSession::next() {
  const auto row = step(rows_, "SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
  if (!row) return row.problems();
  if (!*row) return std::optional<SessionReader::Message>();
  return std::optional(SessionReader::Message{topics()[(*row)->topic], (*row)->stamp, rows_->bytes(2)});
}

Result<std::optional<SessionSource::Row>> SqliteSession::next_row() {
  auto row = step(sizes_, "SELECT topic_id, timestamp, length(data) FROM messages ORDER BY timestamp, id");
  if (row && *row) (*row)->bytes = sizes_->integer(2);
  return row;
}

Result<std::optional<std::string>> SqliteSession::first_of(const std::string& topic) const {
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

}  // namespace

Result<std::unique_ptr<SessionSource>> open_sqlite_session(const std::filesystem::path& path) {
  Result<sqlite::Database> database = open_database(path);
  if (!database) return database.problems();
  auto session = std::make_unique<SqliteSession>(std::move(*database));
  if (Problems problems = session->begin(); !problems.empty()) return problems;
  return std::unique_ptr<SessionSource>(std::move(session));
}

}  // namespace aisle
