#include "aisle/formats/bags/bag_reader.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "aisle/core/random.hpp"
#include "bag_writers.hpp"
#include "session_samples.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

ros::String text_message(int i) {
  return {"message " + std::to_string(i) + std::string(static_cast<std::size_t>(i * 37 % 90), '.')};
}

/// Texts on two topics, 0.1 s apart.
std::vector<WrittenMessage> texts(int count, Written as = Written::kCdr, double begin_s = 100) {
  std::vector<WrittenMessage> messages;
  for (int i = 0; i < count; ++i)
    messages.push_back(written(i % 3 == 1 ? "/b" : "/a", begin_s + 0.1 * i, text_message(i), as));
  return messages;
}

struct ReadBag {
  std::vector<std::string> texts;
  std::vector<long> numbers;
  std::vector<BagTopic> topics;
  std::string warnings, problems;
};

ReadBag read_bag(const fs::path& path) {
  ReadBag read;
  auto reader = BagReader::open(path);
  if (!reader) {
    read.problems = to_string(reader.problems());
    return read;
  }
  while (true) {
    const auto message = reader->next();
    if (!message) {
      read.problems = to_string(message.problems());
      break;
    }
    if (!*message) break;
    const auto text =
        parse_message<ros::String>((*message)->bytes, reader->topics()[(*message)->topic].encoding);
    read.texts.push_back(text ? text->data : "(unreadable)");
    read.numbers.push_back((*message)->number);
  }
  read.topics = reader->topics();
  read.warnings = to_string(reader->warnings());
  return read;
}

std::vector<std::string> expected_texts(int count) {
  std::vector<std::string> texts;
  for (int i = 0; i < count; ++i) texts.push_back(text_message(i).data);
  return texts;
}

struct StoreCase {
  std::string name;
  std::string file;
  std::function<void(const fs::path&, int)> write;
};

StoreCase mcap_case(const std::string& name, const McapLayout& layout) {
  return {"Mcap" + name, "bag.mcap",
          [layout](const fs::path& path, int count) { write_file(path, mcap_bytes(texts(count), layout)); }};
}

StoreCase ros1_case(const std::string& compression, bool has_index = true) {
  return {"Ros1_" + compression + (has_index ? "" : "NoIndex"), "bag.bag",
          [=](const fs::path& path, int count) {
            write_file(path, ros1_bag_bytes(texts(count, Written::kRos1), {compression, 4, has_index}));
          }};
}

StoreCase sqlite_case(int schema) {
  return {"SqliteSchema" + std::to_string(schema), "bag.db3",
          [schema](const fs::path& path, int count) { write_db3(path, texts(count), schema); }};
}

class BagStores : public testing::TestWithParam<StoreCase> {
 protected:
  void SetUp() override { GetParam().write(path(), 11); }
  fs::path path() const { return place_ / GetParam().file; }

 private:
  SessionPlace place_;
};

TEST_P(BagStores, GiveEveryMessageInOrder) {
  EXPECT_TRUE(is_bag(path()));
  const ReadBag read = read_bag(path());
  EXPECT_EQ(read.problems, "");
  EXPECT_EQ(read.texts, expected_texts(11));
  EXPECT_THAT(read.numbers, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
  ASSERT_THAT(read.topics, SizeIs(2));
  EXPECT_EQ(read.topics[0].name, "/a");
  EXPECT_EQ(read.topics[0].type, "std_msgs/msg/String");
  EXPECT_EQ(read.topics[0].messages, 7);
  EXPECT_EQ(read.topics[1].messages, 4);
  EXPECT_EQ(read.topics[0].latched, GetParam().name != "SqliteSchema1");
}

TEST_P(BagStores, GiveOnlyTheWantedTopicsWithTheNumbersOfAll) {
  auto reader = BagReader::open(path());
  ASSERT_TRUE(reader.ok());
  (void)reader->next();
  for (int round = 0; round < 2; ++round) {
    reader->want({1});
    std::vector<long> numbers;
    while (const auto message = *reader->next()) {
      EXPECT_EQ(message->topic, 1U);
      numbers.push_back(message->number);
    }
    EXPECT_THAT(numbers, ElementsAre(2, 5, 8, 11));
  }
}

TEST_P(BagStores, GiveTheWholeMessagesBeforeACut) {
  const std::string whole = *read_whole_file(path());
  const bool is_sqlite = path().extension() == ".db3";
  std::size_t most = 0;
  for (std::size_t length = 0; length < whole.size(); length += is_sqlite ? 97 : 1) {
    write_file(path(), std::string_view(whole).substr(0, length));
    const ReadBag read = read_bag(path());
    const auto count = read.texts.size();
    EXPECT_EQ(read.texts, expected_texts(static_cast<int>(count))) << length;
    EXPECT_GE(count, most) << length;
    EXPECT_TRUE(read.problems.empty() || count == 0) << read.problems;
    EXPECT_TRUE(!read.warnings.empty() || !read.problems.empty() || count == 11) << length;
    EXPECT_EQ(read.warnings.find('\n'), std::string::npos) << read.warnings;
    most = count;
  }
  EXPECT_GE(most, is_sqlite ? 0U : 11U);
}

TEST_P(BagStores, SurviveFlippedBytes) {
  const std::string whole = *read_whole_file(path());
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    for (int flip = 0; flip < 3; ++flip)
      damaged[random.index(damaged.size())] = static_cast<char>(random.bits());
    write_file(path(), damaged);
    (void)read_bag(path());
  }
}

TEST_P(BagStores, AreReadWhenPackedAsAFile) {
  const std::string whole = *read_whole_file(path());
  const fs::path file = path().string() + ".zstd";
  write_file(file, packed("zstd", whole));
  EXPECT_TRUE(is_bag(file));
  EXPECT_EQ(read_bag(file).texts, expected_texts(11));
}

INSTANTIATE_TEST_SUITE_P(All, BagStores,
                         testing::Values(mcap_case("", {}), mcap_case("Lz4", {"lz4"}),
                                         mcap_case("Zstd", {"zstd"}), mcap_case("Unchunked", {"", 0}),
                                         mcap_case("WithoutSummary", {"zstd", 4, false}), ros1_case("none"),
                                         ros1_case("bz2"), ros1_case("lz4"), ros1_case("lz4", false),
                                         sqlite_case(1), sqlite_case(2), sqlite_case(3), sqlite_case(4)),
                         [](const auto& test) { return test.param.name; });

std::string metadata_listing(const std::string& files, const std::string& more = "") {
  return "rosbag2_bagfile_information:\n  custom_data: ~\n" + more + "  relative_file_paths: " + files +
         "\n  storage_identifier: mcap\n  version: 9\n  ros_distro: rolling\n";
}

TEST(BagReader, SplitBagsAreMergedByTheirStampsInTheOrderOfTheMetadata) {
  const SessionPlace place;
  const auto all = texts(12);
  write_file(place / "bag/x_9.mcap", mcap_bytes({all[0], all[1], all[2], all[4]}));
  write_file(place / "bag/x_10.mcap", mcap_bytes({all[3], all[5], all[6], all[7]}));
  write_file(place / "bag/a.mcap", mcap_bytes({all[8], all[9], all[10], all[11]}));
  EXPECT_EQ(read_bag(place / "bag").texts, expected_texts(12));
  write_file(place / "bag/metadata.yaml", metadata_listing("[bag/x_9.mcap, x_10.mcap, a.mcap]"));
  const ReadBag read = read_bag(place / "bag");
  EXPECT_EQ(read.texts, expected_texts(12));
  EXPECT_EQ(read.warnings, "");
}

TEST(BagReader, ASplitBagWhoseClockWasSetBackKeepsItsOrder) {
  const SessionPlace place;
  auto all = texts(8);
  for (std::size_t i = 4; i < 8; ++i) all[i].log_stamp -= 50'000'000'000;
  write_file(place / "bag/x_0.mcap", mcap_bytes({all.begin(), all.begin() + 4}));
  write_file(place / "bag/x_1.mcap", mcap_bytes({all.begin() + 4, all.end()}));
  write_file(place / "bag/metadata.yaml", metadata_listing("[x_0.mcap, x_1.mcap]"));
  EXPECT_EQ(read_bag(place / "bag").texts, expected_texts(8));
}

TEST(BagReader, MissingAndUnlistedFilesAreSaid) {
  const SessionPlace place;
  write_file(place / "bag/x_0.mcap", mcap_bytes(texts(3)));
  write_file(place / "bag/y.mcap", mcap_bytes(texts(3)));
  write_file(place / "bag/metadata.yaml", metadata_listing("[x_0.mcap, x_1.mcap]"));
  const ReadBag read = read_bag(place / "bag");
  EXPECT_EQ(read.texts, expected_texts(3));
  EXPECT_THAT(read.warnings, HasSubstr("relative_file_paths: 'x_1.mcap' is missing"));
  EXPECT_THAT(read.warnings, HasSubstr("y.mcap: is left out"));
}

TEST(BagReader, MessagesThatWereCompressedOneByOneAreUnpacked) {
  const SessionPlace place;
  auto messages = texts(5);
  for (WrittenMessage& message : messages) message.bytes = packed("zstd", message.bytes);
  write_db3(place / "bag.db3", messages);
  EXPECT_EQ(read_bag(place / "bag.db3").texts, expected_texts(5));
}

TEST(BagReader, MessagesWhoseStampIsBeyondAllTimesAreLeftOutAndSaid) {
  const SessionPlace place;
  auto messages = texts(5);
  messages[3].log_stamp = ros::kStampEnd_ns;
  messages[4].log_stamp = -1;  // MCAP's stamps have no sign: almost 2^64
  write_file(place / "bag.mcap", mcap_bytes(messages));
  const ReadBag read = read_bag(place / "bag.mcap");
  EXPECT_EQ(read.texts, expected_texts(3));
  EXPECT_THAT(read.warnings, HasSubstr("messages whose stamp is 2^62 ns or more are left out"));
}

TEST(BagReader, OtherCompressionsAndSerialisationsAreRefusedByName) {
  const SessionPlace place;
  write_db3(place / "bag.db3", texts(5), 4, "protobuf");
  EXPECT_THAT(read_bag(place / "bag.db3").problems, HasSubstr("serialised as 'protobuf'"));
  write_file(place / "bag.mcap", mcap_bytes(texts(5), {.encoding = "json"}));
  EXPECT_THAT(read_bag(place / "bag.mcap").problems, HasSubstr("serialised as 'json'"));
  write_file(place / "bag/x.mcap", mcap_bytes(texts(3)));
  write_file(place / "bag/metadata.yaml", metadata_listing("[x.mcap]", "  compression_format: lzma\n"));
  EXPECT_THAT(read_bag(place / "bag").problems, HasSubstr("'lzma' is not read, only zstd"));
}

TEST(BagReader, WhatIsNoBagIsSaid) {
  const SessionPlace place;
  write_file(place / "a.bag", "hello, world");
  EXPECT_THAT(read_bag(place / "a.bag").problems, HasSubstr("is not a bag"));
  write_file(place / "b.bag", "#ROSBAG V1.2\n");
  EXPECT_THAT(read_bag(place / "b.bag").problems, HasSubstr("older version"));
  EXPECT_THAT(read_bag(place / "none").problems, HasSubstr("no such bag"));
  write_file(place / "folder/readme.txt", "hello");
  EXPECT_THAT(read_bag(place / "folder").problems, HasSubstr("holds no bag"));
  EXPECT_FALSE(is_bag(place / "folder"));
  EXPECT_FALSE(is_bag(place / "none.bag"));
}

TEST(BagReader, AJournalIsMergedAndNothingBesideTheBagChanges) {
  const SessionPlace place;
  fs::create_directories(place / "bag");
  write_db3(place / "whole.db3", texts(4));
  {
    auto database = sqlite::Database::create(place / "whole.db3");
    (void)database->run("PRAGMA wal_autocheckpoint = 0");
    (void)database->run(
        "INSERT INTO messages(topic_id, timestamp, data) SELECT topic_id, timestamp, data FROM messages");
    for (const char* ending : {"", "-wal"})
      fs::copy_file(place / ("whole.db3" + std::string(ending)),
                    place / ("bag/bag_0.db3" + std::string(ending)));
  }
  const auto before = state_of_folder(place / "bag");
  EXPECT_THAT(read_bag(place / "bag").texts, SizeIs(8));
  EXPECT_EQ(state_of_folder(place / "bag"), before);
}

TEST(BagReader, SizesThatAChunkOnlyClaimsAreRefused) {
  const SessionPlace place;
  std::string bytes = mcap_bytes(texts(11), {"zstd", 4, false});
  const std::size_t chunk = bytes.find(mcap_record(1, sized("ros2") + sized("test"))) +
                            mcap_record(1, sized("ros2") + sized("test")).size();
  bytes.replace(chunk + 9 + 16, 8, number_bytes(std::uint64_t{1} << 40));
  write_file(place / "bag.mcap", bytes);
  EXPECT_THAT(read_bag(place / "bag.mcap").problems,
              HasSubstr("claims 1099511627776 bytes, at most 1073741824 are read"));
}

TEST(BagReader, ADamagedChunkCostsNoOther) {
  const SessionPlace place;
  std::string bytes = ros1_bag_bytes(texts(12, Written::kRos1));
  const std::size_t message = bytes.find("message 5");
  bytes.replace(message - 12, 8, std::string(8, '\xFF'));
  write_file(place / "bag.bag", bytes);
  const ReadBag read = read_bag(place / "bag.bag");
  EXPECT_THAT(read.texts, SizeIs(testing::Ge(9U)));
  EXPECT_EQ(read.texts.back(), text_message(11).data);
  EXPECT_THAT(read.warnings, HasSubstr("is damaged"));
}

}  // namespace
}  // namespace aisle
