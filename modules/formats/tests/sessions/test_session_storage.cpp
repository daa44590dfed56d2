/// What a session holds does not depend on its storage, and an MCAP file is read as far as it goes.
#include <gmock/gmock.h>
#include <unistd.h>

#include <tuple>

#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "aisle/formats/sessions/session_summary.hpp"
#include "aisle/formats/sessions/session_writer.hpp"
#include "session_samples.hpp"
#include "written_file.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using StoredMessages = std::vector<std::tuple<std::string, std::string, bool, ros::Stamp_ns, std::string>>;

struct ReadSession {
  StoredMessages messages;
  std::string trouble;
};

ReadSession read_session(const fs::path& directory) {
  auto reader = SessionReader::open(directory);
  if (!reader) return {{}, to_string(reader.problems())};
  ReadSession read;
  while (true) {
    const auto message = reader->next();
    if (!message) return read.trouble = to_string(message.problems()), read;
    if (!message->has_value()) return read;
    const auto& [topic, stamp, cdr] = **message;
    read.messages.emplace_back(topic.name, topic.type, topic.latched, stamp, std::string(cdr));
  }
}

/// A session of 30 cycles in 3 s.
void record_in(const fs::path& directory, SessionStorage storage) {
  auto record = SessionRecord::create(directory, false, sample_vehicle(), sample_origin(),
                                      {ImageCoding::Kind::kPng}, storage);
  ASSERT_TRUE(record.ok()) << to_string(record.problems());
  for (int i = 0; i < 30; ++i) {
    const Observation observation = sample_observation(i);
    ASSERT_THAT(record->keep_truth(observation.stamp_s, {0.1 * i, 0, 0.01 * i}), IsEmpty());
    ASSERT_TRUE(record->keep(observation).ok());
    ASSERT_THAT(record->keep(sample_decision(i)), IsEmpty());
  }
  ASSERT_THAT(record->close(), IsEmpty());
}

class McapSessionTest : public testing::Test {
 protected:
  void SetUp() override { record_in(place / "drive", SessionStorage::kMcap); }

  fs::path file() const { return place / "drive/drive_0.mcap"; }
  std::string bytes() const { return *read_whole_file(file()); }

  SessionPlace place;
};

TEST_F(McapSessionTest, HoldsTheSameAsADatabase) {
  record_in(place / "other", SessionStorage::kSqlite);
  const ReadSession mcap = read_session(place / "drive"), sqlite = read_session(place / "other");
  EXPECT_EQ(mcap.trouble, "");
  EXPECT_THAT(mcap.messages, testing::SizeIs(testing::Gt(200U)));
  EXPECT_TRUE(mcap.messages == sqlite.messages);
  const auto summary = summarise_session(place / "drive"), of_database = summarise_session(place / "other");
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->messages, of_database->messages);
  EXPECT_EQ(summary->last, of_database->last);
  ASSERT_EQ(summary->topics.size(), of_database->topics.size());
  for (std::size_t i = 0; i < summary->topics.size(); ++i) {
    EXPECT_EQ(summary->topics[i].topic, of_database->topics[i].topic);
    EXPECT_EQ(summary->topics[i].bytes, of_database->topics[i].bytes);
  }
  auto reader = SessionReader::open(place / "drive"), other = SessionReader::open(place / "other");
  EXPECT_EQ(*reader->first_of("/odom"), *other->first_of("/odom"));
  EXPECT_FALSE(reader->first_of("/nothing")->has_value());
}

TEST_F(McapSessionTest, IsABagOfRos2) {
  EXPECT_THAT(*read_whole_file(place / "drive/metadata.yaml"),
              testing::AllOf(HasSubstr("storage_identifier: mcap\n"), HasSubstr("- \"drive_0.mcap\"\n")));
  const auto overview = bag_overview(place / "drive");
  ASSERT_TRUE(overview.ok());
  EXPECT_EQ(to_string(overview->warnings), "");
  EXPECT_EQ(overview->messages, static_cast<long>(read_session(place / "drive").messages.size()));
}

TEST_F(McapSessionTest, TheSameMessagesGiveTheSameBytes) {
  const SessionPlace elsewhere;
  record_in(elsewhere / "drive", SessionStorage::kMcap);
  EXPECT_TRUE(*read_whole_file(elsewhere / "drive/drive_0.mcap") == bytes());
}

TEST_F(McapSessionTest, CutAnywhereItIsReadUpToAWholeCycle) {
  const std::string whole = bytes();
  const StoredMessages all = read_session(place / "drive").messages;
  const auto stamp_of = [](const auto& message) { return std::get<ros::Stamp_ns>(message); };
  std::size_t before = 0;
  Random random(3);
  for (std::size_t length = 1; length < whole.size(); length += 1 + random.index(3000)) {
    write_file(file(), whole.substr(0, length));
    const ReadSession read = read_session(place / "drive");
    if (!read.trouble.empty()) {
      EXPECT_THAT(read.trouble, HasSubstr("drive_0.mcap: ")) << length;
      EXPECT_LT(length, 100U) << "it has begun";
      continue;
    }
    ASSERT_LE(read.messages.size(), all.size());
    ASSERT_TRUE(std::equal(read.messages.begin(), read.messages.end(), all.begin())) << length;
    EXPECT_GE(read.messages.size(), before) << length;
    before = read.messages.size();
    if (before > 0 && before < all.size()) {
      EXPECT_LT(stamp_of(all[before - 1]), stamp_of(all[before])) << length;
    }
    EXPECT_TRUE(summarise_session(place / "drive").ok()) << length;
  }
  EXPECT_GT(before, all.size() - 20) << "its last cycle";
  auto cycles = SessionCycles::open(place / "drive");
  ASSERT_TRUE(cycles.ok()) << to_string(cycles.problems());
}

TEST_F(McapSessionTest, DamageIsAProblemThatNamesTheFile) {
  const std::string whole = bytes();
  std::size_t read_whole = 0;
  for (std::size_t at = 8; at + 8 < whole.size(); at += 997) {
    std::string damaged = whole;
    for (std::size_t i = 0; i < 8; ++i) damaged[at + i] = '\xff';
    write_file(file(), damaged);
    const ReadSession read = read_session(place / "drive");
    if (read.trouble.empty()) {
      ++read_whole;  // the damage is within a message
    } else {
      EXPECT_THAT(read.trouble, HasSubstr("drive_0.mcap")) << at;
    }
  }
  EXPECT_GT(read_whole, 0U);
}

TEST(McapSession, AnotherOrderThanThatOfTheStampsIsRefused) {
  const SessionPlace place;
  {
    auto writer = SessionWriter::create(place / "bag", false, SessionStorage::kMcap);
    ASSERT_THAT(writer->write({"/text", ros::String::kType}, 5'000'000'000, "second"), IsEmpty());
    ASSERT_THAT(writer->write({"/text", ros::String::kType}, 4'000'000'000, "first"), IsEmpty());
    ASSERT_THAT(writer->close(), IsEmpty());
  }
  EXPECT_THAT(read_session(place / "bag").trouble,
              HasSubstr("bag_0.mcap:2: this message is older than the one before"));
}

TEST(McapSession, ATypeOfOthersHasNoDefinition) {
  const SessionPlace place;
  {
    auto writer = SessionWriter::create(place / "bag", false, SessionStorage::kMcap);
    ASSERT_THAT(writer->write({"/own", "own_msgs/msg/Thing"}, 5, "bytes"), IsEmpty());
    EXPECT_THAT(writer->write({"no topic", ros::String::kType}, 6, "bytes"), SizeIs(1));
    EXPECT_FALSE(writer->close().empty());
  }
  EXPECT_THAT(read_session(place / "bag").messages, IsEmpty());
  {
    auto writer = SessionWriter::create(place / "bag", true, SessionStorage::kMcap);
    ASSERT_THAT(writer->write({"/own", "own_msgs/msg/Thing"}, 5, "bytes"), IsEmpty());
    ASSERT_THAT(writer->close(), IsEmpty());
  }
  EXPECT_THAT(read_session(place / "bag").messages,
              ElementsAre(std::tuple("/own", "own_msgs/msg/Thing", false, ros::Stamp_ns{5}, "bytes")));
}

TEST(SessionStorage, ASessionThatWasKilledBeforeItsFirstSecondSaysSo) {
  for (const SessionStorage storage : {SessionStorage::kSqlite, SessionStorage::kMcap}) {
    const fs::path directory =
        fs::temp_directory_path() / ("aisle_first_second_" + std::to_string(::getpid()));
    const auto writer = SessionWriter::create(directory, true, storage);  // what it has now, a kill leaves
    ASSERT_TRUE(writer.ok());
    EXPECT_THAT(to_string(SessionCycles::open(directory).problems()),
                HasSubstr("ended before its first second"));
    fs::remove_all(directory);
  }
}

}  // namespace
}  // namespace aisle
