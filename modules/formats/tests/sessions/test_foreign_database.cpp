/// Databases of others: nothing of them changes, nothing in them runs, and reading them ends.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/sessions/session_summary.hpp"
#include "session_samples.hpp"
#include "sessions/sqlite.hpp"
#include "written_file.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kForeignTables =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, "
    "offered_qos_profiles TEXT); INSERT INTO topics VALUES (1, '/scan', 'sensor_msgs/msg/LaserScan', 'cdr', "
    "'');"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER, metadata TEXT);";
constexpr const char* kForeignMessages =
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB);"
    "INSERT INTO messages VALUES (1, 1, 1, x'00');";
constexpr const char* kEndless =
    "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i > 0) SELECT i FROM n";

class ForeignDatabase : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder());
    write_file(folder() / "metadata.yaml",
               "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n"
               "  relative_file_paths: [bag_0.db3]\n");
  }

  fs::path folder() const { return place / "bag"; }
  fs::path file() const { return folder() / "bag_0.db3"; }

  /// @param journalled  the database is left as by a recorder that was killed
  void write_database(const std::string& sql, bool journalled = false) const {
    auto database = sqlite::Database::create(place / "made.db3");
    ASSERT_EQ(to_string(database->run(sql.c_str())), "");
    const char* const mode = journalled ? "PRAGMA wal_autocheckpoint = 0" : "PRAGMA journal_mode = DELETE";
    ASSERT_EQ(to_string(database->run(mode)), "");
    for (const char* ending : {"", "-wal"}) {
      if (fs::exists(place / (std::string("made.db3") + ending)))
        fs::copy_file(place / (std::string("made.db3") + ending), file().string() + ending);
    }
  }

  std::string trouble_as_bag() const {
    const auto overview = bag_overview(folder());
    return overview ? to_string(overview->warnings) : to_string(overview.problems());
  }
  std::string trouble_as_session() const {
    const auto summary = summarise_session(folder());
    return summary ? "" : to_string(summary.problems());
  }

  SessionPlace place;
};

TEST_F(ForeignDatabase, ViewsVirtualTablesAndComputedColumnsAreNotRead) {
  const std::string view = fmt::format(
      "CREATE VIEW messages(id, topic_id, timestamp, data) AS SELECT i, 1, i, "
      "x'00' FROM ({})",
      kEndless);
  const std::string search = "CREATE VIRTUAL TABLE messages USING fts5(topic_id, timestamp, data)";
  const std::string computed =
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB AS "
      "(zeroblob(200000000)))";
  for (const std::string& messages : {view, search, computed}) {
    fs::remove(place / "made.db3");
    fs::remove(file());
    write_database(kForeignTables + messages);
    EXPECT_THAT(trouble_as_session(), HasSubstr("it needs the tables topics and messages")) << messages;
    EXPECT_THAT(trouble_as_bag(), HasSubstr("it needs the tables topics and messages")) << messages;
  }
}

TEST_F(ForeignDatabase, ATriggerIsNotRunAndTheFolderStaysAsItIs) {
  write_database(fmt::format("{}{}CREATE TRIGGER endless BEFORE INSERT ON metadata BEGIN SELECT max(i) FROM "
                             "({}); END",
                             kForeignTables, kForeignMessages, kEndless),
                 true);
  ASSERT_TRUE(fs::exists(file().string() + "-wal"));
  const FolderState before = state_of_folder(folder());
  EXPECT_EQ(trouble_as_session(), "");
  EXPECT_EQ(summarise_session(folder())->messages, 1);
  EXPECT_EQ(bag_overview(folder())->messages, 1);
  EXPECT_EQ(state_of_folder(folder()), before);
}

TEST_F(ForeignDatabase, IsReadInAFolderThatNobodyMayWrite) {
  for (const bool journalled : {false, true}) {
    fs::remove(place / "made.db3");
    fs::remove(file());
    write_database(std::string(kForeignTables) + kForeignMessages, journalled);
    ::chmod(folder().c_str(), 0555);
    EXPECT_EQ(trouble_as_session(), "") << journalled;
    EXPECT_EQ(bag_overview(folder())->messages, 1) << journalled;
    ::chmod(folder().c_str(), 0755);
  }
}

TEST_F(ForeignDatabase, AStatementWithoutEndEnds) {
  write_database(std::string(kForeignTables) + kForeignMessages);
  const auto database = sqlite::Database::open(file());
  ASSERT_TRUE(database.ok()) << to_string(database.problems());
  auto sum = database->prepare(fmt::format("SELECT max(i) FROM ({})", kEndless).c_str());
  ASSERT_TRUE(sum.ok());
  const auto step = sum->step();
  ASSERT_FALSE(step.ok());
  EXPECT_THAT(to_string(step.problems()), HasSubstr("bag_0.db3: cannot be read: that takes more steps than"));
  auto short_one = database->prepare("SELECT count(*) FROM messages");
  EXPECT_TRUE(short_one->step().ok()) << "another one has its own steps";
}

TEST_F(ForeignDatabase, RowsThatHoldMoreThanTheFileEnd) {
  write_database(std::string(kForeignTables) + kForeignMessages);
  const auto database = sqlite::Database::open(file());
  auto rows = database->prepare(fmt::format("SELECT zeroblob(10000) FROM ({})", kEndless).c_str());
  int read = 0;
  auto step = rows->step();
  for (; step.ok() && *step; step = rows->step()) ++read;
  EXPECT_THAT(to_string(step.problems()), HasSubstr("would hold more bytes than the whole file"));
  EXPECT_LE(read * 10000U, fs::file_size(file()));
}

TEST_F(ForeignDatabase, CannotBeWrittenThroughAnOpenOne) {
  for (const bool journalled : {false, true}) {
    fs::remove(place / "made.db3");
    fs::remove(file());
    write_database(std::string(kForeignTables) + kForeignMessages, journalled);
    const auto database = sqlite::Database::open(file());
    EXPECT_THAT(to_string(database->run("DELETE FROM messages")), HasSubstr("readonly database"));
  }
}

}  // namespace
}  // namespace aisle
