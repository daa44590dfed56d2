#include <gtest/gtest.h>

#include "aisle/guidance/hand_driver.hpp"

namespace aisle {
namespace {

Decision step(HandDriver& driver, double stamp_s, const OperatorInput& input = {}, bool bumper = false) {
  return driver.step({.stamp_s = stamp_s, .operator_input = input, .bumper_pressed = bumper});
}

OperatorInput requested(const Command& command) {
  return {.requested = command};
}

TEST(HandDriver, WaitsForTheFirstRequest) {
  HandDriver driver({});
  EXPECT_EQ(step(driver, 0.1).state, "waiting");
  EXPECT_EQ(step(driver, 0.1).command, Command{});
}

TEST(HandDriver, DrivesAsRequestedWithinItsLimits) {
  HandDriver driver({.speed_max_mps = 0.4, .reverse_speed_max_mps = 0.2, .steering_max_rad = 0.5});
  EXPECT_EQ(step(driver, 0.1, requested({0.3, -0.2, 0})).command, (Command{0.3, -0.2, 0}));
  EXPECT_EQ(step(driver, 0.2, requested({9, 9, 0})).command, (Command{0.4, 0.5, 0}));
  EXPECT_EQ(step(driver, 0.3, requested({-9, -9, 0})).command, (Command{-0.2, -0.5, 0}));
}

TEST(HandDriver, StopsHalfASecondAfterTheLastRequest) {
  HandDriver driver({.request_age_max_s = 0.5});
  step(driver, 1, requested({.speed_mps = 0.3}));
  EXPECT_EQ(step(driver, 1.5).command.speed_mps, 0.3);
  const Decision late = step(driver, 1.6);
  EXPECT_EQ(late.command, Command{});
  EXPECT_EQ(late.status, NavigatorStatus::kGoing);
  EXPECT_EQ(step(driver, 1.7, requested({.speed_mps = 0.3})).command.speed_mps, 0.3);
}

TEST(HandDriver, EndsWhenTheOperatorQuits) {
  HandDriver driver({});
  step(driver, 1, requested({.speed_mps = 0.3}));
  const Decision end = step(driver, 1.1, {.quit = true});
  EXPECT_EQ(end.status, NavigatorStatus::kDone);
  EXPECT_EQ(end.command, Command{});
}

TEST(HandDriver, FailsWhenTheOperatorGivesUp) {
  HandDriver driver({});
  const Decision end = step(driver, 1.1, {.quit = true, .gives_up = true});
  EXPECT_EQ(end.status, NavigatorStatus::kFailed);
  EXPECT_EQ(end.state, "given up");
  EXPECT_EQ(end.command, Command{});
}

TEST(HandDriver, FailsOnBumperContact) {
  HandDriver driver({});
  const Decision end = step(driver, 1, requested({.speed_mps = 0.3}), true);
  EXPECT_EQ(end.status, NavigatorStatus::kFailed);
  EXPECT_EQ(end.command, Command{});
}

}  // namespace
}  // namespace aisle
