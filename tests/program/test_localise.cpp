#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

class Localise : public WorkplaceWithLog {
 protected:
  /// A map of the log's own building: as a building file and as map_server's files.
  void make_map() { ASSERT_EQ(run_aisle({"map", log(), "--out", at("out"), "--json"}).exit_code, 0); }
};

TEST_F(Localise, FindsARecordingInABuildingAndInAMapOfCells) {
  make_map();
  for (const char* known : {"/building.json", "/map.yaml"}) {
    const ProgramRun run = run_aisle({"localise", log(), "--building", at("out") + known, "--relations",
                                      relations(), "--out", at("poses.tum"), "--force", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
    const auto figures = run.json()["figures"];
    EXPECT_EQ(figures["found"], true) << known;
    EXPECT_EQ(figures["wrong_confident"], 0);
    EXPECT_GT(figures["found_share"], 0.5);
    EXPECT_LT(figures["translation_m"]["mean"], 0.04);
    EXPECT_FALSE(read_bytes(at("poses.tum")).empty());
  }
}

TEST_F(Localise, RefusesABuildingWithoutWallsByName) {
  const std::string building =
      file("empty.json", R"({"format": "aisle.building", "version": 3, "name": "x"})");
  const ProgramRun run = run_aisle({"localise", log(), "--building", building});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("empty.json"));
}

TEST_F(Localise, RefusesAMissingBuildingByName) {
  const ProgramRun run = run_aisle({"localise", log(), "--building", at("none.yaml")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("none.yaml"));
}

}  // namespace
}  // namespace aisle
