#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "session_samples.hpp"
#include "written_file.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

const SessionTopic kTopic{"/count", ros::String::kType};
constexpr ros::Stamp_ns kPeriod_ns = 100'000'000;

std::string payload(ros::Stamp_ns stamp) {
  return std::to_string(stamp) + std::string(static_cast<std::size_t>(stamp / kPeriod_ns % 5000), 'x');
}

/// The stamps in a session; every message must contain what was written to it.
std::vector<ros::Stamp_ns> stamps_in(const fs::path& directory) {
  auto reader = SessionReader::open(directory);
  EXPECT_TRUE(reader.ok()) << to_string(reader.problems());
  std::vector<ros::Stamp_ns> stamps;
  while (reader.ok()) {
    const auto message = reader->next();
    EXPECT_TRUE(message.ok()) << to_string(message.problems());
    if (!message || !message->has_value()) break;
    EXPECT_TRUE((*message)->cdr == payload((*message)->stamp));
    stamps.push_back((*message)->stamp);
  }
  return stamps;
}

/// A process that records one message after the other and reports the stamp of each through a pipe.
class RecordingProcess {
 public:
  explicit RecordingProcess(const fs::path& directory, SessionStorage storage = SessionStorage::kSqlite) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) record(directory, storage, ends[1]);
    ::close(ends[1]);
    stamp_pipe_ = ends[0];
  }
  RecordingProcess(const RecordingProcess&) = delete;
  RecordingProcess& operator=(const RecordingProcess&) = delete;
  ~RecordingProcess() { ::close(stamp_pipe_); }

  /// Waits for that many messages, then kills the process; returns the stamp of the last message that it
  /// wrote.
  ros::Stamp_ns kill_after(int messages) {
    ros::Stamp_ns last = 0;
    for (int i = 0; i < messages; ++i) next(last);
    ::kill(process_, SIGKILL);
    while (next(last)) {
    }
    ::waitpid(process_, nullptr, 0);
    return last;
  }

 private:
  bool next(ros::Stamp_ns& stamp) const { return ::read(stamp_pipe_, &stamp, sizeof stamp) == sizeof stamp; }

  [[noreturn]] static void record(const fs::path& directory, SessionStorage storage, int stamp_pipe) {
    auto writer = SessionWriter::create(directory, false, storage);
    for (ros::Stamp_ns stamp = kPeriod_ns; writer.ok(); stamp += kPeriod_ns) {
      if (!writer->write(kTopic, stamp, payload(stamp)).empty()) break;
      if (::write(stamp_pipe, &stamp, sizeof stamp) != sizeof stamp) break;
    }
    ::_exit(1);
  }

  pid_t process_ = 0;
  int stamp_pipe_ = 0;
};

TEST(KilledSession, OpensAndMissesLessThanItsLastSecond) {
  const SessionPlace place;
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    const fs::path directory = place / ("killed" + std::to_string(round));
    const auto storage = round % 5 < 3 ? SessionStorage::kSqlite : SessionStorage::kMcap;
    const ros::Stamp_ns last = RecordingProcess(directory, storage)
                                   .kill_after(static_cast<int>(1 + random.index(round < 25 ? 40 : 1500)));
    const std::vector<ros::Stamp_ns> kept = stamps_in(directory);
    for (std::size_t i = 0; i < kept.size(); ++i)
      ASSERT_EQ(kept[i], static_cast<ros::Stamp_ns>(i + 1) * kPeriod_ns) << "round " << round;
    const ros::Stamp_ns end = kept.empty() ? 0 : kept.back();
    EXPECT_LT(last - end, 1'000'000'000 + 2 * kPeriod_ns) << "round " << round;
  }
}

TEST(KilledSession, StaysAsItIsWhenItIsRead) {
  const SessionPlace place;
  RecordingProcess(place / "killed").kill_after(100);
  EXPECT_TRUE(fs::exists(place / "killed/killed_0.db3-wal"));
  const auto before = state_of_folder(place / "killed");
  EXPECT_GE(stamps_in(place / "killed").size(), 90U);
  EXPECT_EQ(state_of_folder(place / "killed"), before);
}

TEST(SessionWriter, ASessionBeingRecordedCanBeRead) {
  const SessionPlace place;
  auto writer = SessionWriter::create(place / "live", false);
  ASSERT_TRUE(writer.ok());
  for (ros::Stamp_ns stamp = kPeriod_ns; stamp <= 25 * kPeriod_ns; stamp += kPeriod_ns)
    ASSERT_THAT(writer->write(kTopic, stamp, payload(stamp)), IsEmpty());
  EXPECT_EQ(stamps_in(place / "live").size(), 20U) << "the last half second is not kept yet";
  ASSERT_THAT(writer->write(kTopic, 26 * kPeriod_ns, payload(26 * kPeriod_ns)), IsEmpty());
  ASSERT_THAT(writer->close(), IsEmpty());
  EXPECT_EQ(stamps_in(place / "live").size(), 26U);
}

TEST(SessionWriter, MessagesOfOneStampAreNeverSplit) {
  const SessionPlace place;
  auto writer = SessionWriter::create(place / "live", false);
  ASSERT_TRUE(writer.ok());
  for (ros::Stamp_ns stamp = kPeriod_ns; stamp <= 31 * kPeriod_ns; stamp += kPeriod_ns) {
    ASSERT_THAT(writer->write(kTopic, stamp, payload(stamp)), IsEmpty());
    EXPECT_EQ(stamps_in(place / "live").size() % 2, 0U) << stamp;
    ASSERT_THAT(writer->write(kTopic, stamp, payload(stamp)), IsEmpty());
  }
}

/// While this lives, no file may grow beyond so many bytes, as if the disk were full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

/// Drives on forever, and remembers the last command.
class TirelessVehicle final : public Vehicle {
 public:
  const VehicleDescription& description() const override { return description_; }
  std::optional<Observation> sense() override { return sample_observation(cycle_++); }
  void act(const Command& command) override { last_command = command; }

  Command last_command;

 private:
  VehicleDescription description_ = sample_vehicle();
  int cycle_ = 0;
};

class StraightOn final : public Navigator {
  Decision step(const Observation&) override { return {.command = {.speed_mps = 1}, .state = "on"}; }
};

class FullDiskTest : public testing::TestWithParam<SessionStorage> {};

TEST_P(FullDiskTest, EndsTheMissionWithAProblemAndAStandingVehicle) {
  const SessionPlace place;
  auto record = SessionRecord::create(place / "drive", false, sample_vehicle(), sample_origin(),
                                      {ImageCoding::Kind::kRaw}, GetParam());
  ASSERT_TRUE(record.ok());
  TirelessVehicle vehicle;
  StraightOn navigator;
  SilentProgress progress;
  {
    const FullDisk full(2 << 20);
    const auto end = run_mission(vehicle, navigator, *record, progress);
    ASSERT_FALSE(end.ok());
    EXPECT_THAT(to_string(end.problems()), testing::ContainsRegex("drive_0.[a-z0-9]*: cannot be written: "));
    EXPECT_EQ(vehicle.last_command, Command{});
    EXPECT_FALSE(record->close().empty());
  }
  auto cycles = SessionCycles::open(place / "drive");
  ASSERT_TRUE(cycles.ok()) << to_string(cycles.problems());
  EXPECT_TRUE(cycles->next()->has_value());
}

INSTANTIATE_TEST_SUITE_P(Storages, FullDiskTest,
                         testing::Values(SessionStorage::kSqlite, SessionStorage::kMcap),
                         [](const auto& storage) {
                           return storage.param == SessionStorage::kMcap ? "Mcap" : "Sqlite";
                         });

std::string refusal(const fs::path& directory, bool force = false) {
  const auto writer = SessionWriter::create(directory, force);
  return writer.ok() ? "" : to_string(writer.problems());
}

TEST(SessionWriter, NeverOverwritesWithoutForce) {
  const SessionPlace place;
  record_sample(place / "drive", 3);
  const std::string before = *read_whole_file(place / "drive/drive_0.db3");
  EXPECT_THAT(refusal(place / "drive"), HasSubstr("is not empty; --force"));
  EXPECT_TRUE(*read_whole_file(place / "drive/drive_0.db3") == before);
  EXPECT_EQ(refusal(place / "drive", true), "");
  EXPECT_THAT(stamps_in(place / "drive"), IsEmpty());
}

TEST(SessionWriter, ARunsPictureIsReplacedWithItsSession) {
  const SessionPlace place;
  record_sample(place / "drive", 3);
  std::ofstream(place / "drive" / kDrivenImage) << "<svg/>";
  EXPECT_EQ(refusal(place / "drive", true), "");
  EXPECT_FALSE(fs::exists(place / "drive" / kDrivenImage));
}

TEST(SessionWriter, NeverRemovesWhatIsNotASession) {
  const SessionPlace place;
  record_sample(place / "drive", 3);
  std::ofstream(place / "drive/thesis.txt") << "years of work";
  EXPECT_THAT(refusal(place / "drive", true), HasSubstr("thesis.txt: is not part of a session"));
  EXPECT_TRUE(fs::exists(place / "drive/drive_0.db3"));
}

TEST(SessionWriter, SaysWhyADirectoryWillNotDo) {
  const SessionPlace place;
  std::ofstream(place / "file") << "x";
  EXPECT_THAT(refusal(place / "file"), HasSubstr("file: is not a directory"));
  EXPECT_THAT(refusal(place / "file/drive"), HasSubstr("cannot be made"));
  EXPECT_THAT(refusal("/proc/drive"), HasSubstr("cannot be made"));
}

TEST(SessionWriter, SaysThatADirectoryIsReadOnly) {
  const SessionPlace place;
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::create_directory(place / "closed");
  fs::permissions(place / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(refusal(place / "closed"), HasSubstr("cannot be written to"));
}

TEST(SessionWriter, ATopicMustBeNamedLikeOne) {
  const SessionPlace place;
  auto writer = SessionWriter::create(place / "drive", false);
  EXPECT_THAT(to_string(writer->write({"/my topic", ros::String::kType}, 0, "")), HasSubstr("is no topic"));
}

TEST(SessionWriter, ADiscardedSessionLeavesNothing) {
  const SessionPlace place;
  auto writer = SessionWriter::create(place / "drive", false);
  ASSERT_THAT(writer->write(kTopic, 1, "x"), IsEmpty());
  writer->discard();
  EXPECT_FALSE(fs::exists(place / "drive"));
}

}  // namespace
}  // namespace aisle
