#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Show : public Workplace {};

constexpr const char* kBuildingWithRoutes = AISLE_SOURCE_DIR "/tests/golden/building_routes.v3.json";

TEST_F(Show, SaysWhatIsKnownOfABuildingAndDrawsIt) {
  const ProgramRun run = run_aisle({"show", kBuildingWithRoutes, "--out", at("shown"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["routes"][0]["name"], "desk to stairs");
  EXPECT_EQ(figures["landmarks"], 2);
  EXPECT_THAT(read_bytes(at("shown/building.svg")), HasSubstr("<svg"));
  EXPECT_THAT(read_bytes(at("shown/building.png")), StartsWith("\x89PNG"));
  EXPECT_EQ(run_aisle({"show", kBuildingWithRoutes, "--out", at("shown")}).exit_code, 2)
      << "it would be replaced";
  EXPECT_THAT(run_aisle({"show", at("none.json"), "--json"}), IsRefused("none.json: no such file"));
}

TEST_F(Show, ListsWhatIsShippedAndEachCanBeUsedByItsName) {
  const ProgramRun run = run_aisle({"list", "worlds", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto worlds = run.json()["figures"]["worlds"];
  ASSERT_GT(worlds.size(), 5U);
  for (const auto& world : worlds) {
    EXPECT_FALSE(world["description"].get<std::string>().empty()) << world["name"];
    EXPECT_EQ(run_aisle({"sim", "show", world["name"].get<std::string>()}).exit_code, 0) << world["name"];
  }
  EXPECT_THAT(run_aisle({"list"}).out, HasSubstr("\nvehicles\n"));
  EXPECT_THAT(run_aisle({"list", "mazes", "--json"}), IsRefused("worlds"));
}

}  // namespace
}  // namespace aisle
