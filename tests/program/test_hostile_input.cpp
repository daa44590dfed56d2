#include <gmock/gmock.h>
#include <sys/stat.h>
#include <zlib.h>

#include <filesystem>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Inputs that somebody made to break something: every one is refused in words.
class HostileInput : public Workplace {
 protected:
  /// Every verb that takes a file or a session, with this one.
  std::vector<Arguments> all_verbs_with(const std::string& path) const {
    return {{"map", path},
            {"info", path},
            {"replay", path},
            {"import", path, "--out", at("imported")},
            {"convert", path, "--out", at("world.yaml")},
            {"explore", path},
            {"drive", path},
            {"sim", "log", path, "--out", at("log")},
            {"sim", "show", path, "--out", at("shown.png")},
            {"go", path, "place", "--world", "l-corridor"},
            {"map", path, "--relations", path},
            {"explore", "l-corridor", "--vehicle", path},
            {"explore", "l-corridor", "--params", path},
            {"drive", "l-corridor", "--faults", path},
            {"calibrate", "camera", path},
            {"detect", path},
            {"maze", "explore", path}};
  }
};

std::string gzip_of_zeros(const std::string& path, int mebibytes) {
  const gzFile packed = gzopen(path.c_str(), "wb1");
  const std::string zeros(1 << 20, '0');
  for (int i = 0; i < mebibytes; ++i) gzwrite(packed, zeros.data(), static_cast<unsigned>(zeros.size()));
  gzclose(packed);
  return path;
}

TEST_F(HostileInput, WhatCouldWaitForEverIsRefusedByEveryVerb) {
  ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  for (const std::string& path : {at("pipe"), std::string("/dev/zero")}) {
    for (const Arguments& arguments : all_verbs_with(path)) {
      const ProgramRun run = run_aisle(arguments);
      EXPECT_EQ(run.exit_code, 2) << arguments[0] << " " << arguments[1] << ": " << run.err;
    }
  }
}

TEST_F(HostileInput, WhatUnpacksToAbsurdlyMoreIsRefusedByEveryVerb) {
  const std::string bomb = gzip_of_zeros(at("bomb.gz"), 64);
  for (const Arguments& arguments : all_verbs_with(bomb)) {
    const ProgramRun run = run_aisle(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments[0] << " " << arguments[1] << ": " << run.err;
    EXPECT_THAT(run.err, Not(HasSubstr("internal error")));
  }
}

TEST_F(HostileInput, WordsOfAFileDoNotMoveTheCursor) {
  const std::string plan = file("wild.txt", "0 0 1 \x1b]0;title\x07\xff\n");
  const std::string world = file("wild.yaml", "\x1b[2J: 1\nname: \"\xff\"\n");
  for (const std::string& path : {plan, world, at("none\x1b[2J\xff")}) {
    for (const Arguments& arguments : all_verbs_with(path)) {
      const ProgramRun run = run_aisle(arguments);
      EXPECT_THAT(run.err + run.out,
                  AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\xff")), Not(HasSubstr("\x07"))))
          << arguments[0];
    }
  }
}

TEST_F(HostileInput, AFailureSaysItsProblemsInJsonToo) {
  const ProgramRun run = run_aisle({"map", at("none.log"), "--json"});
  EXPECT_EQ(run.json()["problems"][0]["where"], at("none.log"));
  EXPECT_EQ(run.json()["problems"][0]["what"], "no such file");
  const ProgramRun misspelt = run_aisle({"map", at("none.log"), "--jsn", "--json"});
  EXPECT_EQ(misspelt.json()["problems"][0]["where"], "aisle map");
}

TEST_F(HostileInput, APlanThatIsNoneIsNamedForWhatItIs) {
  const auto convert = [&](const std::string& plan) {
    return run_aisle({"convert", plan, "--out", at("world.yaml"), "--json"});
  };
  EXPECT_THAT(convert(file("b.json", "{\"format\": \"aisle.building\"}")),
              IsRefused("is a building that aisle learned; `aisle go` drives in one"));
  EXPECT_THAT(convert(file("b.zip", "PK\x03\x04 and more")),
              IsRefused("is a zip archive; unpack it first; plans are"));
  EXPECT_THAT(convert(file("b.html", "<!DOCTYPE html><p>")), IsRefused("is a web page (HTML); plans are"));
  EXPECT_THAT(convert(file("b.tiff", std::string("II*\0\0\0\0\0", 8))),
              IsRefused("is not an image that can be read"));
}

}  // namespace
}  // namespace aisle
