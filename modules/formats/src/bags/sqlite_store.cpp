#include "bags/sqlite_store.hpp"

#include <fmt/format.h>

#include <utility>

namespace aisle {
namespace fs = std::filesystem;

Result<std::unique_ptr<BagStore>> SqliteStore::open(const fs::path& path, TopicTable& topics) {
  auto store = std::unique_ptr<SqliteStore>(new SqliteStore(path, topics));
  if (Problems problems = store->open_database(); !problems.empty()) return problems;
  if (Problems problems = store->read_topics(); !problems.empty()) return problems;
  return std::unique_ptr<BagStore>(std::move(store));
}

Problems SqliteStore::open_database() {
  auto database = sqlite::Database::open(shown_path());
  const bool has_journal = database && database->is_copy();
  if (!has_journal) {
    auto pages = SqlitePages::open(shown_path());
    if (!pages) return pages.problems();
    if (pages->bytes() < pages->stated_bytes()) {
      database = sqlite::Database::open_cut(shown_path());
      take_cut(std::move(*pages));
    }
  }
  if (!database) return database.problems();
  database_ = std::make_unique<sqlite::Database>(std::move(*database));
  return {};
}

void SqliteStore::take_cut(SqlitePages pages) {
  pages_ = std::move(pages);
  cut_rows_ = pages_->messages();
  warn(fmt::format("is cut off at byte {} of {}; the {} whole messages are read", pages_->bytes(),
                   pages_->stated_bytes(), cut_rows_.size()));
}

Problems SqliteStore::read_topics() {
  auto tables = SessionTables::read(*database_);
  if (!tables) return tables.problems();
  tables_ = std::move(*tables);
  for (const SessionTopic& topic : tables_->topics()) {
    topic_of_.push_back(
        topics().index_of({.name = topic.name, .type = with_msg(topic.type), .latched = topic.latched}));
  }
  return {};
}

Result<BagStore::Survey> SqliteStore::survey() {
  begin(false);
  Survey survey;
  while (const auto row = next_row()) {
    if (!row->topic) continue;
    if (!survey.first) survey.first = row->stamp;
    topics().count(*row->topic, 1);
    ++survey.messages;
  }
  rewind();
  return survey;
}

void SqliteStore::rewind() {
  has_begun_ = false;
}

void SqliteStore::begin(bool with_data) {
  has_begun_ = true;
  number_ = 0;
  rows_.reset();
  if (pages_) return;
  // The data of other topics is not even read from the disk.
  std::string wanted;
  for (std::size_t i = 0; with_data && i < topic_of_.size(); ++i) {
    if (topics().is_wanted(topic_of_[i]))
      wanted += fmt::format("{}{}", wanted.empty() ? "" : ",", tables_->id(i));
  }
  const std::string sql = fmt::format(
      "SELECT topic_id, timestamp, CASE WHEN topic_id IN ({}) THEN data END FROM messages ORDER BY rowid",
      wanted);
  auto rows = database_->prepare(sql.c_str());
  if (rows) rows_ = std::move(*rows);
}

bool SqliteStore::step() {
  const auto next = static_cast<std::size_t>(number_);
  if (pages_ ? next >= cut_rows_.size() : !rows_) return false;
  if (!pages_) {
    const Result<bool> more = rows_->step();
    if (!more) warn(fmt::format("is damaged; the {} messages before are read", number_));
    if (!more || !*more) return false;
  }
  ++number_;
  return true;
}

std::optional<SqliteStore::Row> SqliteStore::next_row() {
  if (!step()) return std::nullopt;
  const SqlitePages::Row* const cut = pages_ ? &cut_rows_[static_cast<std::size_t>(number_) - 1] : nullptr;
  const auto topic = tables_->index_of(cut ? cut->topic_id : rows_->integer(0));
  const auto stamp = tables_->stamp_of(cut ? cut->timestamp : rows_->integer(1));
  if (topic && stamp) return Row{topic_of_[*topic], *stamp};
  warn((topic ? stamp.problems() : topic.problems()).front().what + "; such messages are left out");
  return Row{};
}

std::string_view SqliteStore::data() {
  return pages_ ? pages_->data(cut_rows_[static_cast<std::size_t>(number_) - 1]) : rows_->bytes(2);
}

Result<std::optional<StoredMessage>> SqliteStore::next() {
  if (!has_begun_) begin(true);
  while (const auto row = next_row()) {
    if (row->topic && topics().is_wanted(*row->topic))
      return std::optional(StoredMessage{*row->topic, row->stamp, number_, data()});
  }
  return std::optional<StoredMessage>();
}

}  // namespace aisle
