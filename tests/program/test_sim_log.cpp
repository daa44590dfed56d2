#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

class SimLog : public WorkplaceWithLog {
 protected:
  ProgramRun record(const std::string& world, const std::string& seed, const std::string& out) const {
    return run_aisle(
        {"sim", "log", AISLE_SOURCE_DIR "/worlds/" + world, "--seed", seed, "--out", at(out), "--json"});
  }
};

TEST_F(SimLog, SaysThatItIsSimulated) {
  const auto result = record("small-office.yaml", "7", "out").json();
  EXPECT_EQ(result["verb"], "sim log");
  EXPECT_EQ(result["figures"]["simulated"], true);
  EXPECT_EQ(result["figures"]["seed"], 7);
  EXPECT_THAT(names_in(at("out")), ElementsAre("simulated-trip.log", "true.relations", "true.tum"));
  EXPECT_EQ(result["files"].size(), 3);
}

TEST_F(SimLog, SameSeedGivesTheSameFilesAndAnotherSeedOthers) {
  record("small-office.yaml", "1", "again");
  record("small-office.yaml", "2", "other");
  for (const std::string& name : names_in(at("sim"))) {
    EXPECT_TRUE(read_bytes(at("sim/" + name)) == read_bytes(at("again/" + name))) << name;
  }
  EXPECT_FALSE(read_bytes(log()) == read_bytes(at("other/simulated-trip.log")));
}

TEST_F(SimLog, EveryShippedWorldCanBeRecordedAndMapped) {
  for (const std::string& world : names_in(AISLE_SOURCE_DIR "/worlds")) {
    if (!world.ends_with(".yaml")) continue;
    ASSERT_EQ(record(world, "1", world).exit_code, 0) << world;
    const ProgramRun map = run_aisle(
        {"map", at(world + "/simulated-trip.log"), "--relations", at(world + "/true.relations"), "--json"});
    ASSERT_EQ(map.exit_code, 0) << world << map.err;
    EXPECT_LT(map.json()["figures"]["translation_m"]["mean"], 0.05) << world;
  }
}

}  // namespace
}  // namespace aisle
