#include <gtest/gtest.h>

#include "workplace.hpp"

namespace aisle {
namespace {

class Explore : public Workplace {};

TEST_F(Explore, AnInterruptedTripGoesOnFromWhereItStoodAndComesHome) {
  const ProgramRun whole =
      run_aisle({"explore", "l-corridor", "--session", at("trip"), "--set", "time_max_s=60", "--json"});
  EXPECT_EQ(whole.exit_code, 1) << whole.err;
  ASSERT_EQ(run_aisle({"cut", at("trip"), "--from", "0", "--to", "55", "--out", at("part")}).exit_code, 0);
  EXPECT_EQ(run_aisle({"replay", at("part"), "--json"}).json()["figures"]["different"], 0);

  const ProgramRun other = run_aisle({"explore", "l-corridor", "--resume", at("part"), "--json"});
  EXPECT_EQ(other.exit_code, 2);
  const ProgramRun order = run_aisle({"explore", "l-corridor", "--resume", at("part"), "--order", "published",
                                      "--set", "time_max_s=60", "--json"});
  EXPECT_EQ(order.exit_code, 2);
}

TEST_F(Explore, WhatWasLearnedBeforeTheInterruptionIsKnownAfterIt) {
  ASSERT_EQ(run_aisle({"explore", "l-corridor", "--session", at("trip"), "--json"}).exit_code, 0);
  ASSERT_EQ(run_aisle({"cut", at("trip"), "--from", "0", "--to", "90", "--out", at("part")}).exit_code, 0);
  const ProgramRun resumed =
      run_aisle({"explore", "l-corridor", "--resume", at("part"), "--out", at("out"), "--json"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  const auto figures = resumed.json()["figures"];
  EXPECT_EQ(figures["certificate"], true);
  EXPECT_GE(figures["covered_share"], 0.98);
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_LE(figures["home_error_m"], 0.1);
  EXPECT_GT(figures["duration_s"], 90);
  EXPECT_THAT(names_in(at("out")),
              testing::ElementsAre("building.json", "exploration.png", "exploration.svg", "report.html"));
  EXPECT_NE(read_bytes(at("out") + "/report.html").find("States and stack"), std::string::npos);
}

}  // namespace
}  // namespace aisle
