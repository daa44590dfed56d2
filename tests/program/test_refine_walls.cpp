/// A building that was mapped on one trip is refined by another.

#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RefineWalls : public WorkplaceWithLog {
 protected:
  void make_building() const {
    ASSERT_EQ(run_aisle({"map", log(), "--out", at("map"), "--json"}).exit_code, 0);
  }
  std::string building() const { return at("map/building.json"); }

  std::string record(const std::string& world, const std::string& seed) const {
    EXPECT_EQ(run_aisle({"sim", "log", world, "--seed", seed, "--out", at(world + seed)}).exit_code, 0);
    return at(world + seed) + "/simulated-trip.log";
  }
};

TEST_F(RefineWalls, AnotherTripConfirmsTheBuildingAndItsFrame) {
  make_building();
  const ProgramRun run =
      run_aisle({"refine", building(), record("small-office", "2"), "--out", at("refined"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.out << run.err;
  const auto figures = run.json()["figures"];
  const auto& trip = figures["trips"][0];
  EXPECT_GT(trip["found"].get<double>() / trip["scans"].get<double>(), 0.5);
  EXPECT_GT(trip["agreement"], 0.85);
  EXPECT_LT(trip["corrected_m"], 0.03);
  EXPECT_THAT(trip["doors"], IsEmpty());
  EXPECT_LT(figures["after"]["bytes"].get<double>(), 1.3 * figures["before"]["bytes"].get<double>());
  EXPECT_THAT(names_in(at("refined")),
              ElementsAre("building.json", "building.png", "building.svg", "changes.png", "changes.svg"));

  const ProgramRun diff = run_aisle({"diff", building(), at("refined/building.json"), "--json"});
  ASSERT_EQ(diff.exit_code, 0) << diff.out << diff.err;
  EXPECT_NEAR(diff.json()["figures"]["alignment"]["x_m"].get<double>(), 0, 0.02);
  EXPECT_NEAR(diff.json()["figures"]["alignment"]["heading_deg"].get<double>(), 0, 0.2);
}

TEST_F(RefineWalls, ATripElsewhereIsABadResultThatSaysWhyAndWritesNothing) {
  make_building();
  const ProgramRun run =
      run_aisle({"refine", building(), record("l-corridor", "1"), "--out", at("refined"), "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_EQ(run.json()["ok"], false);
  EXPECT_FALSE(run.json()["figures"]["why_refused"].get<std::string>().empty());
  EXPECT_THAT(names_in(at("refined")), IsEmpty());
}

TEST_F(RefineWalls, ABuildingWithoutAFloorIsRefusedAndSaysHowToKeepOne) {
  ASSERT_EQ(run_aisle({"map", log(), "--no-floor", "--out", at("map"), "--json"}).exit_code, 0);
  const ProgramRun run = run_aisle({"refine", building(), log(), "--out", at("refined"), "--json"});
  EXPECT_THAT(run, IsRefused("floor: is missing"));
  EXPECT_THAT(names_in(at("refined")), IsEmpty());
}

}  // namespace
}  // namespace aisle
