#include <gmock/gmock.h>
#include <sched.h>
#include <unistd.h>

#include "short_drive.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// While this lives, programs start on one processor, and so with one thread in the ray tracer's pool.
class OnOneProcessor {
 public:
  OnOneProcessor() {
    sched_getaffinity(0, sizeof(all_), &all_);
    int first = 0;
    while (!CPU_ISSET(first, &all_)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    sched_setaffinity(0, sizeof(one), &one);
  }
  ~OnOneProcessor() { sched_setaffinity(0, sizeof(all_), &all_); }
  OnOneProcessor(const OnOneProcessor&) = delete;
  OnOneProcessor& operator=(const OnOneProcessor&) = delete;

 private:
  cpu_set_t all_;
};

class DriveByKeys : public WorkplaceWithKeys {};

TEST_F(DriveByKeys, GoesWhereTheKeysSayAndKeepsASession) {
  const ProgramRun run = run_aisle(drive("drive"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = run.json();
  EXPECT_EQ(result["verb"], "drive");
  EXPECT_EQ(result["figures"]["simulated"], true);
  EXPECT_EQ(result["figures"]["state"], "ended");
  EXPECT_EQ(result["figures"]["collisions"], 0);
  EXPECT_NEAR(result["figures"]["duration_s"], 3.0, 0.11);
  EXPECT_NEAR(result["figures"]["distance_m"], 0.3 * 2.5, 0.15);  // 0.3 m/s for two and a half seconds
  EXPECT_EQ(result["figures"]["pictures"], result["figures"]["cycles"]);
  EXPECT_EQ(result["files"]["session"], at("drive"));
  EXPECT_THAT(names_in(at("drive")), ElementsAre("drive_0.db3", "metadata.yaml"));
}

TEST_F(DriveByKeys, TheSameSeedGivesTheSameBytesWithOneThreadAndWithMany) {
  ASSERT_EQ(run_aisle(drive("many/drive", {"--seed", "7"})).exit_code, 0);
  {
    const OnOneProcessor one;
    ASSERT_EQ(run_aisle(drive("one/drive", {"--seed", "7"})).exit_code, 0);
  }
  ASSERT_EQ(run_aisle(drive("other/drive", {"--seed", "8"})).exit_code, 0);
  for (const char* name : {"drive_0.db3", "metadata.yaml"}) {
    EXPECT_TRUE(read_bytes(at("many/drive/") + name) == read_bytes(at("one/drive/") + name)) << name;
  }
  EXPECT_FALSE(read_bytes(at("many/drive/drive_0.db3")) == read_bytes(at("other/drive/drive_0.db3")));
}

TEST_F(DriveByKeys, NamesWhatIsNotThere) {
  const auto without_images = [](Arguments arguments) {
    arguments.insert(arguments.end(), {"--no-images", "--json"});
    return run_aisle(arguments);
  };
  EXPECT_THAT(without_images({"drive"}), IsRefused("a world or --connect is required"));
  EXPECT_THAT(without_images({"drive", at("no.yaml")}), IsRefused("no.yaml: no such file"));
  EXPECT_THAT(without_images({"drive", "l-corridor", "--vehicle", "cab"}), IsRefused("cab: no such file"));
  EXPECT_THAT(without_images({"drive", "l-corridor", "--faults", "flood"}),
              IsRefused("flood: no such file, nor one of the shipped scenarios: blocked-corridor, "));
  EXPECT_THAT(without_images({"drive", "l-corridor", "--keys", at("none.txt")}), IsRefused("none.txt: "));
  EXPECT_THAT(without_images({"drive", "l-corridor", "--keys", file("bad.txt", "0-1 up\n2 jump\n")}),
              IsRefused("bad.txt:2: "));
  EXPECT_THAT(without_images({"drive", "l-corridor", "--seed", "-1"}), IsRefused("--seed"));
  EXPECT_THAT(without_images({"drive", "l-corridor", "--set", "limits.speed_max_mps=fast"}),
              IsRefused("limits.speed_max_mps"));
}

TEST_F(DriveByKeys, NamesWhatDoesNotGoTogether) {
  file("tight.yaml",
       "format: aisle.world\nversion: 1\nwalls: [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]\n"
       "start: {at: [0.5, 0.5]}\n");
  EXPECT_THAT(run_aisle({"drive", at("tight.yaml"), "--keys", at("keys.txt"), "--json"}),
              IsRefused("tight.yaml: start: the vehicle does not fit there"));
  file("no-tour.yaml",
       "format: aisle.world\nversion: 1\nwalls: [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]\n"
       "start: {at: [5, 5]}\n");
  EXPECT_THAT(run_aisle({"drive", at("no-tour.yaml"), "--operator", "scripted", "--json"}),
              IsRefused("no-tour.yaml: tour: needs at least two waypoints"));
  EXPECT_THAT(
      run_aisle({"drive", file("no-world.yaml", "format: aisle.vehicle\nversion: 1\nwalls: []\n"), "--json"}),
      IsRefused("no-world.yaml:1: format"));
}

TEST_F(DriveByKeys, NeverReplacesASessionUnasked) {
  ASSERT_EQ(run_aisle(drive("drive", {"--no-images"})).exit_code, 0);
  const std::string before = read_bytes(at("drive/drive_0.db3"));
  EXPECT_THAT(run_aisle(drive("drive", {"--no-images", "--seed", "2"})), IsRefused("--force"));
  EXPECT_TRUE(read_bytes(at("drive/drive_0.db3")) == before);
  EXPECT_EQ(run_aisle(drive("drive", {"--no-images", "--seed", "2", "--force"})).exit_code, 0);
  EXPECT_FALSE(read_bytes(at("drive/drive_0.db3")) == before);
}

TEST_F(DriveByKeys, SaysWhereASessionCannotBeWritten) {
  file("taken", "mine");
  EXPECT_THAT(run_aisle(drive("taken")), IsRefused(at("taken")));
  EXPECT_EQ(read_bytes(at("taken")), "mine");
  fs::create_directory(at("notes"));
  file("notes/notes.txt", "mine");
  EXPECT_THAT(run_aisle(drive("notes", {"--force"})), IsRefused(at("notes")));
  EXPECT_THAT(names_in(at("notes")), ElementsAre("notes.txt"));
  EXPECT_THAT(run_aisle({"drive", "mini-corridor", "--out", "/proc/drive", "--json"}),
              IsRefused("/proc/drive"));
}

TEST_F(DriveByKeys, SaysThatADirectoryIsReadOnly) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::create_directory(at("closed"));
  fs::permissions(at("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(run_aisle(drive("closed")), IsRefused(at("closed")));
  EXPECT_THAT(run_aisle(drive("closed/drive")), IsRefused(at("closed/drive")));
  EXPECT_THAT(names_in(at("closed")), IsEmpty());
}

}  // namespace
}  // namespace aisle
