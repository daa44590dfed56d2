#include <gmock/gmock.h>
#include <sqlite3.h>

#include <cmath>
#include <string_view>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/decision_text.hpp"
#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "aisle/formats/sessions/session_writer.hpp"
#include "short_drive.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// The same session, except that the command of one cycle is faster by the last bit.
/// @param cycle  from 1
void copy_with_another_decision(const std::string& session, const std::string& copy, int cycle) {
  auto reader = SessionReader::open(session);
  auto writer = SessionWriter::create(copy, false);
  int decisions = 0;
  while (true) {
    const auto message = reader->next();
    if (!message->has_value()) break;
    std::string cdr((*message)->cdr);
    if ((*message)->topic.name == "/decision" && ++decisions == cycle) {
      auto text = *parse_cdr<ros::String>(cdr);
      Decision decision = *parse_decision(text.data);
      decision.command.speed_mps = std::nextafter(decision.command.speed_mps, 1);
      text.data = decision_text(decision);
      cdr = cdr_bytes(text);
    }
    ASSERT_THAT(writer->write((*message)->topic, (*message)->stamp, cdr), IsEmpty());
  }
  ASSERT_THAT(writer->close(), IsEmpty());
}

class Session : public WorkplaceWithSession {
 protected:
  /// A database in which a view takes the place of the messages.
  std::string endless_view() const {
    sqlite3* database = nullptr;
    sqlite3_open(at("view.db3").c_str(), &database);
    sqlite3_exec(
        database,
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, "
        "offered_qos_profiles TEXT);"
        "CREATE VIEW messages(id, topic_id, timestamp, data) AS WITH RECURSIVE n(i) AS (SELECT 1 UNION "
        "ALL SELECT i + 1 FROM n) SELECT i, 1, i, x'00' FROM n",
        nullptr, nullptr, nullptr);
    sqlite3_close(database);
    return at("view.db3");
  }

  /// All verbs that read a session.
  std::vector<Arguments> readers_of(const std::string& session) const {
    return {{"info", session, "--json"},
            {"replay", session, "--json"},
            {"cut", session, "--from", "0", "--to", "1", "--out", at("cut"), "--json"}};
  }
};

TEST_F(Session, InfoTellsTopicsDurationAndOrigin) {
  ASSERT_EQ(run_aisle(drive("seen")).exit_code, 0);
  const ProgramRun run = run_aisle({"info", at("seen"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_NEAR(figures["duration_s"], 2.9, 0.11);
  EXPECT_EQ(figures["origin"]["navigator"], "hand");
  EXPECT_EQ(figures["origin"]["simulated"], true);
  EXPECT_EQ(figures["origin"]["vehicle"], "mini-vehicle");
  int decisions = 0, images = 0;
  for (const auto& topic : figures["topics"]) {
    if (topic["name"] == "/decision") decisions = topic["messages"];
    if (topic["name"] == "/camera/front/image_raw/compressed") images = topic["messages"];
  }
  EXPECT_GE(decisions, 29);
  EXPECT_EQ(images, decisions);
  EXPECT_THAT(run_aisle({"info", session()}).out, AllOf(HasSubstr("/truth/pose"), HasSubstr("10.00 Hz")));
}

TEST_F(Session, ReplayDecidesTheSameBitForBit) {
  ASSERT_EQ(run_aisle(drive("seen")).exit_code, 0);
  const ProgramRun run = run_aisle({"replay", at("seen"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["different"], 0);
  EXPECT_EQ(figures["compared"], figures["cycles"]);
  EXPECT_GE(figures["compared"], 29);
}

TEST_F(Session, ReplaySaysWhereADecisionIsAnotherOne) {
  copy_with_another_decision(session(), at("changed"), 8);
  const ProgramRun run = run_aisle({"replay", at("changed"), "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["different"], 1);
  EXPECT_EQ(figures["first_difference"]["cycle"], 8);
  EXPECT_NEAR(figures["first_difference"]["stamp_s"], 0.8, 1e-6);
  EXPECT_NE(figures["first_difference"]["recorded"], figures["first_difference"]["replayed"]);
  EXPECT_THAT(run_aisle({"replay", at("changed")}).out, HasSubstr("first in cycle 8 at 0.800 s"));
}

TEST_F(Session, ReplayKnowsItsNavigators) {
  EXPECT_THAT(run_aisle({"replay", session(), "--navigator", "owl", "--json"}),
              IsRefused("'owl' is unknown; there are: hand"));
}

TEST_F(Session, ACutIsASessionOfThatPart) {
  const ProgramRun cut =
      run_aisle({"cut", session(), "--from", "0.5", "--to", "1.5", "--out", at("cut"), "--json"});
  ASSERT_EQ(cut.exit_code, 0) << cut.err;
  EXPECT_NEAR(run_aisle({"info", at("cut"), "--json"}).json()["figures"]["duration_s"], 1.0, 1e-6);
  const auto replay = run_aisle({"replay", at("cut"), "--json"}).json()["figures"];
  EXPECT_EQ(replay["compared"], 11);
  EXPECT_EQ(replay["different"], 0);
}

TEST_F(Session, McapHoldsTheSame) {
  const ProgramRun driven = run_aisle(drive("other", {"--no-images", "--storage", "mcap"}));
  ASSERT_EQ(driven.exit_code, 0) << driven.err;
  EXPECT_THAT(names_in(at("other")), testing::ElementsAre("metadata.yaml", "other_0.mcap"));
  EXPECT_EQ(run_aisle({"replay", at("other"), "--json"}).exit_code, 0);
  const auto figures = [](const std::string& session) {
    auto json = run_aisle({"info", session, "--json"}).json()["figures"];
    json.erase("file_bytes");
    return json;
  };
  EXPECT_EQ(figures(at("other")), figures(session()));
  ASSERT_EQ(run_aisle({"cut", at("other"), "--out", at("back/drive")}).exit_code, 0);
  EXPECT_TRUE(read_bytes(at("back/drive/drive_0.db3")) == read_bytes(database()));
}

TEST_F(Session, CutRefusesPartsThatAreNone) {
  const auto cut = [&](const Arguments& part) {
    Arguments arguments = {"cut", session(), "--out", at("cut"), "--json"};
    arguments.insert(arguments.end(), part.begin(), part.end());
    return run_aisle(arguments);
  };
  EXPECT_THAT(cut({"--from", "2", "--to", "1"}), IsRefused("--to: 1 s is before --from, 2 s"));
  EXPECT_THAT(cut({"--from", "100"}), IsRefused("has no message in that part; it lasts"));
  EXPECT_THAT(cut({"--from", "-1"}), IsRefused("--from"));
  EXPECT_THAT(cut({"--from", "soon"}), IsRefused("--from"));
  EXPECT_FALSE(fs::exists(at("cut")));
  EXPECT_THAT(run_aisle({"cut", session(), "--out", session(), "--force", "--json"}),
              IsRefused("is the session that is to be cut"));
  EXPECT_EQ(run_aisle({"replay", session()}).exit_code, 0);
}

TEST_F(Session, WhatIsNoSessionIsRefusedByEveryVerb) {
  fs::create_directory(at("empty"));
  const std::string log = file("log.txt", "FLASER 0\n");
  for (const std::string& other : {at("nowhere"), at("empty"), log}) {
    for (const Arguments& arguments : readers_of(other)) {
      EXPECT_THAT(run_aisle(arguments), IsRefused(other)) << arguments[0];
    }
  }
  EXPECT_FALSE(fs::exists(at("cut")));
}

TEST_F(Session, DamagedDatabasesAreRefusedByEveryVerb) {
  const std::string whole = read_bytes(database());
  const std::string garbage(whole.size(), '\x5a');
  const std::string_view half = std::string_view(whole).substr(0, whole.size() / 2);
  for (const std::string_view bytes : {std::string_view(), half, std::string_view(garbage)}) {
    write_bytes(database(), bytes);
    for (const Arguments& arguments : readers_of(session())) {
      EXPECT_THAT(run_aisle(arguments), IsRefused("drive_0.db3")) << arguments[0] << bytes.size();
    }
    EXPECT_FALSE(fs::exists(at("cut"))) << bytes.size();
  }
}

TEST_F(Session, DamagedMetadataIsRefusedWithItsLine) {
  for (const char* text : {"", "rosbag2_bagfile_information: [", "hello: world\n"}) {
    file("drive/metadata.yaml", text);
    for (const Arguments& arguments : readers_of(session())) {
      EXPECT_THAT(run_aisle(arguments), IsRefused("metadata.yaml")) << arguments[0] << text;
    }
  }
}

TEST_F(Session, EndedBeforeItsFirstSecondItSaysSo) {
  for (const SessionStorage storage : {SessionStorage::kSqlite, SessionStorage::kMcap}) {
    const std::string killed = at(storage == SessionStorage::kMcap ? "killed-mcap" : "killed");
    const auto recording =
        SessionWriter::create(killed, false, storage);  // its files now are what a kill leaves
    for (const Arguments& reader :
         {Arguments{"info", killed, "--json"}, {"replay", killed, "--json"}, {"learn", killed, "--json"}})
      EXPECT_THAT(run_aisle(reader), IsRefused("ended before its first second")) << reader[0];
  }
}

TEST_F(Session, ReadersChangeNothingInItsFolder) {
  write_bytes(at("drive/drive_0.db3-wal"), "");  // as of a recording that was killed
  write_bytes(at("drive/drive_0.db3-journal"), "left behind by somebody");
  const FolderState before = state_of_folder(session());
  std::vector<Arguments> readers = readers_of(session());
  readers.push_back({"map", session(), "--json"});
  readers.push_back({"import", session(), "--out", at("imported"), "--json"});
  readers.push_back({"learn", session(), "--out", at("learned"), "--json"});
  for (const Arguments& arguments : readers) {
    const ProgramRun run = run_aisle(arguments);
    EXPECT_LE(run.exit_code, 2) << arguments[0] << run.err;
    EXPECT_TRUE(state_of_folder(session()) == before) << arguments[0];
  }
}

TEST_F(Session, ADatabaseWithAnEndlessViewIsRefusedByEveryVerb) {
  write_bytes(database(), read_bytes(endless_view()));
  std::vector<Arguments> readers = readers_of(session());
  readers.push_back({"map", session(), "--json"});
  readers.push_back({"import", session(), "--out", at("imported"), "--json"});
  for (const Arguments& arguments : readers)
    EXPECT_THAT(run_aisle(arguments), IsRefused("it needs the tables topics and messages")) << arguments[0];
}

}  // namespace
}  // namespace aisle
