#include <gmock/gmock.h>

#include <fstream>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "aisle/formats/sessions/session_summary.hpp"
#include "session_samples.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

void write(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string read(const fs::path& path) {
  return *read_whole_file(path);
}

/// Reads a session in every way that there is; returns the first problem, "" if there is none.
std::string trouble_with(const fs::path& directory) {
  if (const auto summary = summarise_session(directory); !summary) return to_string(summary.problems());
  auto cycles = SessionCycles::open(directory);
  if (!cycles) return to_string(cycles.problems());
  while (true) {
    const auto cycle = cycles->next();
    if (!cycle) return to_string(cycle.problems());
    if (!cycle->has_value()) return "";
  }
}

/// A small session whose bytes a test may damage.
class DamagedSession : public testing::Test {
 protected:
  void SetUp() override {
    record_sample(place / "drive", 12);
    bytes = read(database());
  }

  fs::path database() const { return place / "drive/drive_0.db3"; }

  SessionPlace place;
  std::string bytes;
};

TEST_F(DamagedSession, EveryTruncationIsNoticed) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const std::size_t length = i == 0 ? 0 : i == 1 ? bytes.size() - 1 : random.index(bytes.size());
    write(database(), bytes.substr(0, length));
    EXPECT_THAT(trouble_with(place / "drive"), HasSubstr("drive_0.db3: ")) << length << " bytes";
  }
}

TEST_F(DamagedSession, FlippedBytesAreReadOrRefused) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    std::string damaged = bytes;
    for (int flip = 0; flip < 5; ++flip) {
      const std::size_t page = 4096 * random.index(i % 2 == 0 ? 3 : bytes.size() / 4096);
      damaged[page + random.index(i % 3 == 0 ? 120 : 4096)] = static_cast<char>(random.bits());
    }
    write(database(), damaged);
    (void)trouble_with(place / "drive");
  }
}

TEST_F(DamagedSession, SomethingElseThanADatabaseIsNoticed) {
  for (const char* other : {"", "hello", "SQLite format 3"}) {
    write(database(), other);
    EXPECT_THAT(trouble_with(place / "drive"), HasSubstr("drive_0.db3: ")) << other;
  }
}

std::string metadata_with(const std::string& storage, const std::string& compression,
                          const std::string& files) {
  return "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: " + storage +
         "\n  compression_format: \"" + compression + "\"\n  relative_file_paths: " + files + "\n";
}

TEST_F(DamagedSession, BagsOfOtherLayoutsNameTheLayoutThatIsRead) {
  const auto trouble = [&](const std::string& metadata) {
    write(place / "drive/metadata.yaml", metadata);
    return trouble_with(place / "drive");
  };
  EXPECT_EQ(trouble(metadata_with("sqlite3", "", "[drive_0.db3]")), "");
  EXPECT_THAT(trouble(metadata_with("mcap", "", "[drive_0.mcap]")),
              HasSubstr("drive_0.mcap: is missing, though metadata.yaml names it"));
  EXPECT_THAT(trouble(metadata_with("rosbag_v2", "", "[drive_0.bag]")),
              HasSubstr("metadata.yaml: storage_identifier: 'rosbag_v2' is not read, only sqlite3 and mcap"));
  EXPECT_THAT(trouble(metadata_with("sqlite3", "zstd", "[drive_0.db3.zstd]")),
              HasSubstr("metadata.yaml: compression_format: 'zstd' is not read"));
  EXPECT_THAT(trouble(metadata_with("sqlite3", "", "[drive_0.db3, drive_1.db3]")),
              HasSubstr("names 2 files"));
  EXPECT_THAT(trouble(metadata_with("sqlite3", "", "[../drive_0.db3]")), HasSubstr("is not a file beside"));
  EXPECT_THAT(trouble(metadata_with("sqlite3", "", "[other.db3]")), HasSubstr("other.db3: is missing"));
  EXPECT_THAT(trouble(metadata_with("sqlite3", "", "7")), HasSubstr("names no database"));
  EXPECT_THAT(trouble("[1, 2"), HasSubstr("metadata.yaml:1: is not YAML"));
  EXPECT_THAT(trouble("a: b"), HasSubstr("this is not a bag's metadata"));
  EXPECT_THAT(trouble(""), HasSubstr("this is not a bag's metadata"));
}

TEST(SessionReader, SaysWhatIsNotASession) {
  const SessionPlace place;
  EXPECT_THAT(trouble_with(place / "none"), HasSubstr("none: no such session"));
  write(place / "file", "x");
  EXPECT_THAT(trouble_with(place / "file"), HasSubstr("file: is a file; a session is a directory"));
  fs::create_directory(place / "empty");
  EXPECT_THAT(trouble_with(place / "empty"), HasSubstr("empty: has no metadata.yaml"));
}

/// A bag with one message of each topic.
fs::path bag_with(const SessionPlace& place,
                  const std::vector<std::pair<SessionTopic, std::string>>& messages) {
  const fs::path directory = place / "bag";
  auto writer = SessionWriter::create(directory, true);
  EXPECT_TRUE(writer.ok());
  for (const auto& [topic, cdr] : messages) EXPECT_THAT(writer->write(topic, 5, cdr), IsEmpty());
  EXPECT_THAT(writer->close(), IsEmpty());
  return directory;
}

TEST(SessionReader, ABagOfOthersIsReadButIsNoSession) {
  const SessionPlace place;
  const fs::path bag = bag_with(place, {{{"/chatter", "std_msgs/msg/String"}, cdr_bytes(ros::String{"hi"})}});
  const auto summary = summarise_session(bag);
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->messages, 1);
  EXPECT_THAT(trouble_with(bag),
              HasSubstr("bag_0.db3: /session: is missing: this bag is not an aisle session"));
}

TEST(SessionReader, MessagesThatAreNotWhatTheyShouldBeAreReported) {
  const SessionPlace place;
  record_sample(place / "drive", 2);
  auto reader = SessionReader::open(place / "drive");
  const std::string origin = **reader->first_of("/session");
  const std::string vehicle = **reader->first_of("/vehicle_description");
  const auto trouble = [&](const SessionTopic& topic, const std::string& cdr) {
    return trouble_with(bag_with(place, {{{"/session", ros::String::kType}, origin},
                                         {{"/vehicle_description", ros::String::kType}, vehicle},
                                         {topic, cdr}}));
  };
  const SessionTopic wheels{"/wheels", ros::JointState::kType};
  EXPECT_THAT(trouble(wheels, "no CDR"), HasSubstr("/wheels: contains no CDR of sensor_msgs/msg/JointState"));
  ros::JointState one_wheel;
  one_wheel.name = {"wheel"};
  one_wheel.position = {1};
  EXPECT_THAT(trouble(wheels, cdr_bytes(one_wheel)),
              HasSubstr("/wheels: is neither [distance_m, steering_rad] nor"));
  EXPECT_THAT(trouble({"/wheels", ros::String::kType}, cdr_bytes(ros::String{})),
              HasSubstr("/wheels: has messages of type std_msgs/msg/String instead of"));
  EXPECT_THAT(trouble({"/decision", ros::String::kType}, cdr_bytes(ros::String{"{}"})),
              HasSubstr("/decision: has a message that is not a decision (at 0.000 s)"));
  EXPECT_THAT(trouble({"/operator", ros::String::kType}, cdr_bytes(ros::String{"["})),
              HasSubstr("/operator: has a message that is not operator input"));
  ros::Image image;
  image.width = image.height = image.step = 2;
  image.encoding = "mono8";
  image.data = {1, 2, 3};
  const SessionTopic images{"/camera/front/image_raw", ros::Image::kType};
  EXPECT_THAT(trouble(images, cdr_bytes(image)), HasSubstr("2 x 2 pixels in rows of 2 bytes, with 3 bytes"));
  image.encoding = "16UC1";
  EXPECT_THAT(trouble(images, cdr_bytes(image)), HasSubstr("has images in '16UC1'"));
  ros::CompressedImage no_image;
  no_image.data = {1, 2, 3};
  EXPECT_THAT(
      trouble({"/camera/front/image_raw/compressed", ros::CompressedImage::kType}, cdr_bytes(no_image)),
      HasSubstr("is not an image"));
}

TEST(SessionReader, ReplayNeverLooksAtTheTruth) {
  const SessionPlace place;
  record_sample(place / "drive", 1);
  auto reader = SessionReader::open(place / "drive");
  std::vector<std::pair<SessionTopic, std::string>> messages;
  while (const auto message = *reader->next()) {
    const bool is_truth = message->topic.name.starts_with("/truth");
    messages.emplace_back(message->topic, is_truth ? "no CDR" : std::string(message->cdr));
  }
  EXPECT_EQ(trouble_with(bag_with(place, messages)), "");
}

TEST(SessionSummary, CountsMessagesAndTellsGapsOfRegularTopics) {
  const SessionPlace place;
  auto writer = SessionWriter::create(place / "bag", false);
  for (int i = 0; i < 100; ++i) {
    if (i >= 40 && i < 45) continue;
    ASSERT_THAT(writer->write({"/regular", ros::String::kType}, (i + 1) * 100'000'000L, "abc"), IsEmpty());
    if (i * i % 11 == 1) {
      ASSERT_THAT(writer->write({"/now_and_then", ros::String::kType}, (i + 1) * 100'000'000L, "a"),
                  IsEmpty());
    }
  }
  ASSERT_THAT(writer->close(), IsEmpty());
  const auto summary = summarise_session(place / "bag");
  ASSERT_TRUE(summary.ok());
  EXPECT_DOUBLE_EQ(summary->duration_s(), 9.9);
  ASSERT_THAT(summary->topics, SizeIs(2));
  const TopicSummary& regular = summary->topics[0];
  EXPECT_EQ(regular.messages, 95);
  EXPECT_EQ(regular.bytes, 3 * 95);
  EXPECT_DOUBLE_EQ(regular.interval_s, 0.1);
  ASSERT_THAT(regular.gaps, SizeIs(1));
  EXPECT_NEAR(regular.gaps[0].start_s, 3.9, 1e-9);
  EXPECT_NEAR(regular.gaps[0].length_s, 0.6, 1e-9);
  EXPECT_FALSE(summary->topics[1].is_regular);
  EXPECT_THAT(summary->topics[1].gaps, IsEmpty());
}

TEST(SessionSummary, ASessionWithoutMessagesIsOneToo) {
  const SessionPlace place;
  { const auto writer = SessionWriter::create(place / "bag", false); }
  const auto summary = summarise_session(place / "bag");
  ASSERT_TRUE(summary.ok());
  EXPECT_EQ(summary->messages, 0);
  EXPECT_EQ(summary->duration_s(), 0);
}

}  // namespace
}  // namespace aisle
