#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class SimShow : public Workplace {};

constexpr const char* kLaboratory = AISLE_SOURCE_DIR "/worlds/laboratory.yaml";

TEST_F(SimShow, DrawsThePlanAndCountsWhatIsInIt) {
  const ProgramRun run =
      run_aisle({"sim", "show", kLaboratory, "--svg", at("plan.svg"), "--png", at("plan.png"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = run.json();
  EXPECT_EQ(result["verb"], "sim show");
  EXPECT_EQ(result["figures"]["name"], "laboratory");
  EXPECT_EQ(result["figures"]["walls"], 4);
  EXPECT_EQ(result["figures"]["area_m2"], 130);
  EXPECT_EQ(result["figures"]["parking_frames"], 1);
  EXPECT_TRUE(result["figures"]["unreached"].empty());
  EXPECT_THAT(read_bytes(at("plan.svg")), HasSubstr("<svg"));
  EXPECT_THAT(read_bytes(at("plan.png")), StartsWith("\x89PNG"));
}

TEST_F(SimShow, WarnsOfWhatALargeVehicleCannotReach) {
  file("shut.yaml",
       "format: aisle.world\n"
       "version: 1\n"
       "walls: [[[0, 0], [6, 0], [6, 3], [0, 3], [0, 0]], [[3, 0], [3, 3]]]\n"
       "start: {at: [1, 1]}\n"
       "places: [{name: vault, at: [5, 1]}]\n"
       "tour: [[1, 1], [1, 2.8]]\n");
  const ProgramRun run = run_aisle({"sim", "show", at("shut.yaml")});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("cannot get from the start to 'vault'"));
  EXPECT_THAT(run.err, HasSubstr("the tour passes 0.20 m from an obstacle"));
}

TEST_F(SimShow, RefusesToReplaceAPictureUnlessForced) {
  const std::string mine = file("plan.svg", "mine");
  EXPECT_THAT(run_aisle({"sim", "show", kLaboratory, "--svg", mine, "--png", at("plan.png"), "--json"}),
              IsRefused("plan.svg: exists already; --force replaces it"));
  EXPECT_EQ(read_bytes(mine), "mine");
  EXPECT_THAT(names_in(at(".")), testing::ElementsAre("plan.svg"));
  EXPECT_EQ(run_aisle({"sim", "show", kLaboratory, "--svg", mine, "--force"}).exit_code, 0);
  EXPECT_THAT(read_bytes(mine), HasSubstr("<svg"));
}

TEST_F(SimShow, RefusesAWorldThatContradictsItself) {
  file("bad.yaml", "format: aisle.world\nversion: 1\nwalls: []\ntour: [[1, 1]]\n");
  const ProgramRun run = run_aisle({"sim", "show", at("bad.yaml"), "--svg", at("plan.svg")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("bad.yaml:4: tour: needs at least two different points"));
  EXPECT_THAT(names_in(at(".")), testing::Not(testing::Contains("plan.svg")));
}

}  // namespace
}  // namespace aisle
