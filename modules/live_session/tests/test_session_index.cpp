#include "session_index.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/session_writer.hpp"

namespace aisle {
namespace fs = std::filesystem;
namespace {

class Index : public testing::Test {
 protected:
  Index() { fs::create_directories(folder); }
  ~Index() override { fs::remove_all(folder); }

  void record(const std::string& name, double duration_s, SessionStorage storage = SessionStorage::kSqlite) {
    auto session = SessionWriter::create(folder / name, true, storage);
    ASSERT_TRUE(session);
    const SessionTopic topic{"/note", ros::String::kType};
    for (const double time_s : {0.0, duration_s})
      ASSERT_TRUE(session->write(topic, static_cast<ros::Stamp_ns>(time_s * 1e9), cdr_bytes(ros::String{"x"}))
                      .empty());
    ASSERT_TRUE(session->close().empty());
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }

  /// "name file duration_s"
  static std::vector<std::string> lines(SessionIndex& index) {
    std::vector<std::string> lines;
    for (const auto& row : index.rows())
      lines.push_back(row["name"].get<std::string>() + " " + row["file"].get<std::string>() + " " +
                      row["duration_s"].dump());
    return lines;
  }

  using Lines = std::vector<std::string>;
  const fs::path folder = fs::temp_directory_path() / ("aisle-index-" + std::to_string(getpid()));
};

TEST_F(Index, ListsSessionsOfBothKindsAndNothingElse) {
  record("b", 2, SessionStorage::kMcap);
  record("a", 1.5);
  fs::create_directories(folder / "empty");
  fs::create_directories(folder / "damaged");
  write("damaged/metadata.yaml", "[");
  write("notes.txt", "foreign");
  SessionIndex index(folder);
  EXPECT_EQ(lines(index), (Lines{"a a_0.db3 1.5", "b b_0.mcap 2.0"}));
}

TEST_F(Index, SeesWhatChanges) {
  record("a", 1);
  SessionIndex index(folder);
  ASSERT_EQ(lines(index), Lines{"a a_0.db3 1.0"});
  record("a", 3);
  record("b", 1);
  EXPECT_EQ(lines(index), (Lines{"a a_0.db3 3.0", "b b_0.db3 1.0"}));
  fs::remove_all(folder / "a");
  EXPECT_EQ(lines(index), Lines{"b b_0.db3 1.0"});
}

TEST_F(Index, IsKeptForTheNextProgram) {
  record("a", 1);
  SessionIndex first(folder);
  ASSERT_EQ(lines(first).size(), 1U);
  std::string kept;
  std::getline(std::ifstream(folder / ".aisle-sessions.json"), kept, '\0');
  ASSERT_NE(kept.find("1.0"), std::string::npos);
  kept.replace(kept.find("1.0"), 3, "7.0");  // nothing is read again while the session stays as it is
  write(".aisle-sessions.json", kept);
  SessionIndex second(folder);
  EXPECT_EQ(lines(second), Lines{"a a_0.db3 7.0"});
}

TEST_F(Index, IsMadeAgainWhereItIsDamaged) {
  record("a", 1);
  for (const char* text : {"", "{", "[]", R"({"version":1})", R"({"version":1,"sessions":{"a":3}})",
                           R"({"version":1,"sessions":{"a":{"state":1,"row":2}}})", R"({"version":"x"})"}) {
    write(".aisle-sessions.json", text);
    SessionIndex index(folder);
    EXPECT_EQ(lines(index), Lines{"a a_0.db3 1.0"}) << text;
  }
}

TEST_F(Index, OfNoFolderIsEmpty) {
  SessionIndex none{fs::path()};
  EXPECT_TRUE(none.rows().empty());
  SessionIndex missing(folder / "missing");
  EXPECT_TRUE(missing.rows().empty());
}

}  // namespace
}  // namespace aisle
