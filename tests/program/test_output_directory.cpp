#include <gmock/gmock.h>
#include <unistd.h>

#include "workplace.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class OutputDirectory : public WorkplaceWithLog {};

TEST_F(OutputDirectory, ResultsAreNotOverwrittenWithoutForce) {
  fs::create_directory(at("out"));
  write_bytes(at("out/map.png"), "an image of mine");
  write_bytes(at("out/building.json"), "a building of mine");
  const ProgramRun run = run_aisle({"map", log(), "--out", at("out"), "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr(at("out/map.png")));
  EXPECT_THAT(run.err, HasSubstr(at("out/building.json")));
  EXPECT_THAT(run.err, HasSubstr("--force"));
  EXPECT_THAT(run.json()["files"], IsEmpty());
  EXPECT_THAT(names_in(at("out")), ElementsAre("building.json", "map.png"));
  EXPECT_EQ(read_bytes(at("out/map.png")), "an image of mine");
}

TEST_F(OutputDirectory, ForceReplacesResultsAndNothingElse) {
  fs::create_directory(at("out"));
  write_bytes(at("out/map.svg"), "an image of mine");
  write_bytes(at("out/notes.txt"), "notes of mine");
  EXPECT_EQ(run_aisle({"map", log(), "--out", at("out"), "--force"}).exit_code, 0);
  EXPECT_THAT(read_bytes(at("out/map.svg")), HasSubstr("<svg"));
  EXPECT_EQ(read_bytes(at("out/notes.txt")), "notes of mine");
}

TEST_F(OutputDirectory, OtherFilesInItDoNotMatter) {
  fs::create_directory(at("out"));
  write_bytes(at("out/notes.txt"), "notes of mine");
  EXPECT_EQ(run_aisle({"map", log(), "--out", at("out")}).exit_code, 0);
}

TEST_F(OutputDirectory, WhatAKilledRunLeftIsRemovedByTheNext) {
  fs::create_directories(at("out/.unfinished"));
  write_bytes(at("out/.unfinished/map.svg"), "half a map");
  write_bytes(at("out/notes.txt"), "notes of mine");
  EXPECT_EQ(run_aisle({"learn", at("no-session"), "--out", at("out")}).exit_code, 2);
  EXPECT_THAT(names_in(at("out")), ElementsAre("notes.txt"));
}

TEST_F(OutputDirectory, IsRemovedAgainIfThereAreNoResults) {
  fs::create_directory(at("mine"));
  for (const std::string out : {"mine/made/out", "mine/made/out/"}) {
    EXPECT_EQ(run_aisle({"learn", at("no-session"), "--out", at(out)}).exit_code, 2);
    EXPECT_THAT(names_in(at("mine")), IsEmpty()) << out;
  }
  EXPECT_EQ(run_aisle({"learn", at("no-session"), "--out", at("mine")}).exit_code, 2);
  EXPECT_TRUE(fs::exists(at("mine")));
}

TEST_F(OutputDirectory, AFileInItsPlaceIsRefused) {
  file("taken", "mine");
  EXPECT_THAT(run_aisle({"map", log(), "--out", at("taken"), "--json"}), IsRefused(at("taken")));
  EXPECT_THAT(run_aisle({"map", log(), "--out", at("taken/out"), "--json"}), IsRefused(at("taken/out")));
  EXPECT_EQ(read_bytes(at("taken")), "mine");
}

TEST_F(OutputDirectory, OneThatCannotBeMadeIsRefused) {
  EXPECT_THAT(run_aisle({"map", log(), "--out", "/proc/aisle", "--json"}), IsRefused("/proc/aisle: "));
  EXPECT_THAT(run_aisle({"map", log(), "--out", "", "--json"}), IsRefused("--out"));
  EXPECT_THAT(run_aisle({"explore", "l-corridor", "--out", "", "--json"}), IsRefused("--out"));
}

TEST_F(OutputDirectory, ADirectoryInAResultsPlaceIsRefusedBeforeAnythingIsWritten) {
  fs::create_directories(at("out/map.png"));
  EXPECT_THAT(run_aisle({"map", log(), "--out", at("out"), "--force", "--json"}),
              IsRefused(at("out/map.png")));
  EXPECT_THAT(names_in(at("out")), ElementsAre("map.png"));
}

TEST_F(OutputDirectory, OneThatMayNotBeWrittenToIsRefused) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::create_directory(at("out"));
  fs::permissions(at("out"), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(run_aisle({"map", log(), "--out", at("out"), "--json"}), IsRefused(at("out")));
  EXPECT_THAT(names_in(at("out")), IsEmpty());
}

TEST_F(OutputDirectory, IsNotMadeForInputThatIsRefused) {
  EXPECT_EQ(run_aisle({"map", file("empty.log", ""), "--out", at("out")}).exit_code, 2);
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(OutputDirectory, TheSimulatorKeepsToItAsWell) {
  const std::string before = read_bytes(log());
  const Arguments arguments = {"sim",     "log",   AISLE_SOURCE_DIR "/worlds/small-office.yaml",
                               "--seed",  "2",     "--out",
                               at("sim"), "--json"};
  const ProgramRun refused = run_aisle(arguments);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr(log()));
  EXPECT_TRUE(read_bytes(log()) == before);
  Arguments forced = arguments;
  forced.push_back("--force");
  EXPECT_EQ(run_aisle(forced).exit_code, 0);
  EXPECT_FALSE(read_bytes(log()) == before);
}

}  // namespace
}  // namespace aisle
