#include "aisle/formats/session_reader.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "session_files.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

constexpr ros::Stamp_ns kStampEnd_ns = ros::Stamp_ns{1} << 62;
constexpr std::size_t kTopicsMax = 10000;

}  // namespace

/// The open database with its topics and the rows that are still to come.
class SessionReader::Source {
 public:
  explicit Source(sqlite::Database database) : database_(std::move(database)) {}

  Problems begin();
  const std::vector<SessionTopic>& topics() const { return topics_; }
  const fs::path& path() const { return database_.path(); }
  Result<std::optional<Message>> next();
  Result<std::optional<std::string>> first_of(const std::string& topic) const;

 private:
  Problems read_topics();
  Problem damaged(std::string what) const { return {{path().string()}, std::move(what)}; }

  sqlite::Database database_;
  std::vector<SessionTopic> topics_;
  std::map<std::int64_t, std::size_t> index_of_id_;
  std::optional<sqlite::Statement> rows_;
};

Problems SessionReader::Source::begin() {
  if (Problems problems = check_tables(database_); !problems.empty()) return problems;
  if (Problems problems = read_topics(); !problems.empty()) return problems;
  auto rows = database_.prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
  if (!rows) return rows.problems();
  rows_ = std::move(*rows);
  return {};
}

Problems SessionReader::Source::read_topics() {
  auto rows = database_.prepare(
      "SELECT id, name, type, serialization_format, offered_qos_profiles FROM topics ORDER BY id");
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
    topics_.push_back({name, std::string(rows->bytes(2)), is_latched(std::string(rows->bytes(4)))});
  }
}

Result<std::optional<SessionReader::Message>> SessionReader::Source::next() {
  const Result<bool> more = rows_->step();
  if (!more) return more.problems();
  if (!*more) return std::optional<Message>();
  const auto topic = index_of_id_.find(rows_->integer(0));
  if (topic == index_of_id_.end())
    return damaged(fmt::format("has a message of topic {}, which it does not list", rows_->integer(0)));
  const ros::Stamp_ns stamp = rows_->integer(1);
  if (stamp < 0 || stamp >= kStampEnd_ns)
    return damaged(fmt::format("has a message with the stamp {} ns; 0 to 2^62 is read", stamp));
  return std::optional(Message{topics_[topic->second], stamp, rows_->bytes(2)});
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
