#include "live_hand.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

class SetClock final : public Clock {
 public:
  double now_s() const override { return time_s; }
  double time_s = 0;
};

class Hand : public testing::Test {
 protected:
  void say(std::uint64_t sequence, double speed_mps, double age_s = 0) {
    inbox.put({.lease = "t", .sequence = sequence, .age_s = age_s, .command = {.speed_mps = speed_mps}});
  }
  double speed_at(double stamp_s) { return hand.look(stamp_s).requested->speed_mps; }

  SetClock clock;
  DriveInbox inbox{clock};
  LiveHand hand{inbox};
};

TEST_F(Hand, StopsBeforeTheFirstCommand) {
  EXPECT_EQ(speed_at(0), 0);
}

TEST_F(Hand, ObeysACommandForThreeTenthsOfASecondOfTheVehiclesTime) {
  say(1, 0.3);
  EXPECT_EQ(speed_at(10), 0.3);
  EXPECT_EQ(speed_at(10.29), 0.3);
  EXPECT_EQ(speed_at(10.31), 0);
  say(2, 0.2);
  EXPECT_EQ(speed_at(10.4), 0.2);
}

TEST_F(Hand, CountsTheAgeOfACommandOnArrival) {
  say(1, 0.3, 0.25);
  EXPECT_EQ(speed_at(10), 0.3);
  EXPECT_EQ(speed_at(10.1), 0);
  say(2, 0.3, 0.5);
  EXPECT_EQ(speed_at(10.2), 0) << "too old from the beginning";
}

TEST_F(Hand, IgnoresCommandsWhileItIsHeld) {
  hand.hold(true);
  say(1, 0.3);
  EXPECT_EQ(speed_at(1), 0);
  hand.hold(false);
  say(2, 0.3);
  EXPECT_EQ(speed_at(1.1), 0.3);
}

TEST_F(Hand, DropsTheCommandFromBeforeTimeStoodStill) {
  say(1, 0.3);
  EXPECT_EQ(speed_at(10), 0.3);
  hand.forget_command();
  EXPECT_EQ(speed_at(10.1), 0);
}

TEST_F(Hand, PassesOnEachMarkAndTheEndOnce) {
  hand.mark({Mark::Kind::kPlace, "desk"});
  hand.finish();
  const OperatorInput input = hand.look(1);
  EXPECT_EQ(input.marks, (std::vector<Mark>{{Mark::Kind::kPlace, "desk"}}));
  EXPECT_TRUE(input.quit);
  const OperatorInput next = hand.look(1.1);
  EXPECT_TRUE(next.marks.empty());
  EXPECT_FALSE(next.quit);
}

TEST_F(Hand, BeginsADriveWithoutEarlierInput) {
  say(1, 0.3);
  (void)hand.look(5);
  say(2, 0.3);
  hand.finish();
  hand.begin();
  const OperatorInput input = hand.look(0.1);
  EXPECT_EQ(input.requested->speed_mps, 0);
  EXPECT_FALSE(input.quit);
}

}  // namespace
}  // namespace aisle
