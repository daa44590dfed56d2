#include "workplace.hpp"

namespace aisle {
namespace {

class Go : public Workplace {};

constexpr const char* kCarriedBack = R"(format: aisle.scenario
version: 1
name: carried-back
world: l-corridor
events:
  - near: [9, 1.1]
    lift: {at: [14.9, 9], heading_deg: -90}
)";

TEST_F(Go, FindsItselfWhereItIsPutDownAndAgainAfterItWasCarriedAway) {
  ASSERT_EQ(run_aisle({"explore", "l-corridor", "--out", at("explored"), "--json"}).exit_code, 0);
  const ProgramRun run =
      run_aisle({"go", at("explored/building.json"), "home", "--world", "l-corridor", "--start", "14.9,9,-90",
                 "--faults", file("carried.yaml", kCarriedBack), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["arrived"], true);
  EXPECT_EQ(figures["times_lost"], 1);
  EXPECT_EQ(figures["collisions"], 0);
}

}  // namespace
}  // namespace aisle
