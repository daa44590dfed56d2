#pragma once

#include <optional>

#include "bags/bag_store.hpp"
#include "bags/sqlite_pages.hpp"
#include "sessions/session_tables.hpp"
#include "sessions/sqlite.hpp"

namespace aisle {

/// A database of rosbag2, of any version of its tables. Nothing of it or beside it changes.
class SqliteStore : public BagStore {
 public:
  static constexpr std::string_view kMagic{"SQLite format 3\0", 16};

  static Result<std::unique_ptr<BagStore>> open(const std::filesystem::path& path, TopicTable& topics);

  Result<Survey> survey() override;
  Result<std::optional<StoredMessage>> next() override;
  void rewind() override;

 private:
  struct Row {
    std::optional<std::size_t> topic;  ///< in the table
    ros::Stamp_ns stamp = 0;
  };

  using BagStore::BagStore;

  Problems open_database();
  void take_cut(SqlitePages pages);
  Problems read_topics();
  bool step();
  std::string_view data();
  /// The next row; nullopt after the last one that can be read.
  std::optional<Row> next_row();
  /// Begins to read the rows, with the data of wanted topics.
  void begin(bool with_data);

  std::unique_ptr<sqlite::Database> database_;
  std::optional<SessionTables> tables_;
  std::vector<std::size_t> topic_of_;  ///< by index in tables_
  std::optional<sqlite::Statement> rows_;
  std::optional<SqlitePages> pages_;  ///< of a file that is shorter than its header says
  std::vector<SqlitePages::Row> cut_rows_;
  bool has_begun_ = false;
  long number_ = 0;
};

}  // namespace aisle
