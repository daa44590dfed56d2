#include "bags/sqlite_store.hpp"

#include <fmt/format.h>

#include <utility>

#include "bags/byte_stream.hpp"

namespace aisle {
namespace fs = std::filesystem;

namespace {

/// The journals that SQLite would merge into a database when it opens it.
std::vector<std::string> journals_of(const fs::path& database) {
  std::vector<std::string> found;
  for (const char* ending : {"-wal", "-journal"}) {
    std::error_code error;
    const auto bytes = fs::file_size(database.string() + ending, error);
    if (!error && bytes > 0) found.emplace_back(ending);
  }
  return found;
}

/// The bytes of a database by its own header, and those that are there up to a whole page.
struct PagedSize {
  std::uint64_t stated = 0;
  std::uint64_t there = 0;
  std::uint64_t whole = 0;
};

PagedSize paged_size(const fs::path& database) {
  constexpr std::size_t kHeader_bytes = 100;
  auto file = ByteStream::open(database);
  if (!file) return {};
  const std::string_view header = file->peek(kHeader_bytes);
  if (header.size() < kHeader_bytes) return {};
  const auto byte = [&](std::size_t at) { return std::uint64_t{static_cast<unsigned char>(header[at])}; };
  std::uint64_t page = byte(16) << 8 | byte(17);
  if (page == 1) page = 65536;
  if (page < 512) return {};
  const std::uint64_t pages = byte(28) << 24 | byte(29) << 16 | byte(30) << 8 | byte(31);
  return {pages * page, file->size(), file->size() / page * page};
}

Result<TemporaryDirectory> copied_with(const fs::path& database, const std::vector<std::string>& journals) {
  auto directory = TemporaryDirectory::create();
  if (!directory) return directory;
  std::error_code error;
  const fs::path copy = directory->path() / "bag.db3";
  fs::copy_file(database, copy, error);
  for (const std::string& ending : journals) {
    if (!error) fs::copy_file(database.string() + ending, copy.string() + ending, error);
  }
  if (error)
    return Problem{{database.string()}, "needs a copy to be read, which cannot be made: " + error.message()};
  return directory;
}

}  // namespace

Result<std::unique_ptr<BagStore>> SqliteStore::open(const fs::path& path, TopicTable& topics) {
  auto store = std::unique_ptr<SqliteStore>(new SqliteStore(path, topics));
  if (Problems problems = store->open_database(); !problems.empty()) return problems;
  if (Problems problems = store->read_topics(); !problems.empty()) return problems;
  return std::unique_ptr<BagStore>(std::move(store));
}

Problems SqliteStore::open_database() {
  const auto journals = journals_of(path_);
  const PagedSize size = paged_size(path_);
  is_cut_ = journals.empty() && size.there < size.stated;
  // SQLite would take the missing rest of a page for zeros, so a file that ends within one is shortened.
  const bool shorten = is_cut_ && size.whole < size.there;
  fs::path path = path_;
  if (!journals.empty() || shorten) {
    auto copy = copied_with(path_, journals);
    if (!copy) return copy.problems();
    copy_ = std::move(*copy);
    path = copy_->path() / "bag.db3";
    std::error_code error;
    if (shorten) fs::resize_file(path, size.whole, error);
  }
  auto database = journals.empty() ? sqlite::Database::open_unchanged(path) : sqlite::Database::open(path);
  if (!database) return {{{path_.string()}, database.problems().front().what}};
  database_ = std::make_unique<sqlite::Database>(std::move(*database));
  return {};
}

Problems SqliteStore::read_topics() {
  auto tables = SessionTables::read(*database_);
  if (!tables) return {{{path_.string()}, tables.problems().front().what}};
  tables_ = std::move(*tables);
  for (const SessionTopic& topic : tables_->topics()) {
    topic_of_.push_back(
        topics_.index_of({.name = topic.name, .type = with_msg(topic.type), .latched = topic.latched}));
  }
  return {};
}

Result<BagStore::Survey> SqliteStore::survey() {
  begin(false);
  Survey survey;
  while (const auto row = next_row()) {
    if (!row->topic) continue;
    if (!survey.first) survey.first = row->stamp;
    topics_.count(*row->topic, 1);
    ++survey.messages;
  }
  rewind();
  return survey;
}

void SqliteStore::rewind() {
  rows_.reset();
}

void SqliteStore::begin(bool with_data) {
  number_ = 0;
  // The data of other topics is not even read from the disk.
  std::string wanted;
  for (std::size_t i = 0; with_data && i < topic_of_.size(); ++i) {
    if (topics_.is_wanted(topic_of_[i]))
      wanted += fmt::format("{}{}", wanted.empty() ? "" : ",", tables_->id(i));
  }
  const std::string sql = fmt::format(
      "SELECT topic_id, timestamp, CASE WHEN topic_id IN ({}) THEN data END FROM messages ORDER BY rowid",
      wanted);
  auto rows = database_->prepare(sql.c_str());
  if (rows) rows_ = std::move(*rows);
}

std::optional<SqliteStore::Row> SqliteStore::next_row() {
  if (!rows_) return std::nullopt;
  const Result<bool> more = rows_->step();
  if (!more || !*more) {
    if (is_cut_ || !more)
      warn(fmt::format("is {}; the {} messages before are read", is_cut_ ? "cut off" : "damaged", number_));
    return std::nullopt;
  }
  ++number_;
  Row row;
  const auto topic = tables_->index_of(rows_->integer(0));
  const auto stamp = tables_->stamp_of(rows_->integer(1));
  if (topic && stamp) {
    row = {topic_of_[*topic], *stamp};
  } else if (warnings().empty()) {
    warn((topic ? stamp.problems() : topic.problems()).front().what + "; such messages are left out");
  }
  return row;
}

Result<std::optional<StoredMessage>> SqliteStore::next() {
  if (!rows_) begin(true);
  while (const auto row = next_row()) {
    if (row->topic && topics_.is_wanted(*row->topic))
      return std::optional(StoredMessage{*row->topic, row->stamp, number_, rows_->bytes(2)});
  }
  return std::optional<StoredMessage>();
}

}  // namespace aisle
