#include <gtest/gtest.h>

#include "aisle/live/drive_command.hpp"
#include "aisle/live/driver_lease.hpp"
#include "set_clock.hpp"

namespace aisle {
namespace {

class Lease : public testing::Test {
 protected:
  SetClock clock;
  int made = 0;
  DriverLease lease{clock, [this] { return "token " + std::to_string(++made); }};
};

TEST_F(Lease, IsGivenToOneClientAtATime) {
  const auto token = lease.take(1);
  ASSERT_TRUE(token);
  EXPECT_TRUE(lease.is_held());
  EXPECT_FALSE(lease.take(2));
  lease.release("a guess");
  EXPECT_FALSE(lease.take(2));
  lease.release(*token);
  EXPECT_FALSE(lease.is_held());
  EXPECT_TRUE(lease.take(2));
}

TEST_F(Lease, RunsOutUnlessItIsRenewed) {
  const auto token = lease.take(1);
  clock.time_s += DriverLease::kValid_s - 0.1;
  EXPECT_TRUE(lease.renew(*token));
  EXPECT_FALSE(lease.renew("token 0"));
  clock.time_s += DriverLease::kValid_s - 0.1;
  EXPECT_TRUE(lease.is_held());
  clock.time_s += 0.2;
  EXPECT_FALSE(lease.is_held());
  EXPECT_FALSE(lease.renew(*token)) << "what ran out must be taken again";
  EXPECT_TRUE(lease.take(2));
}

TEST_F(Lease, IsFreeWhenItsHolderIsGone) {
  const auto token = lease.take(1);
  lease.gone(2);
  EXPECT_TRUE(lease.is_held());
  lease.gone(1);
  EXPECT_FALSE(lease.renew(*token));
}

TEST(LeaseToken, IsLongAndNeverTheSame) {
  EXPECT_EQ(chance_token().size(), 32);
  EXPECT_NE(chance_token(), chance_token());
}

TEST(DriveCommands, AreReadWhole) {
  const auto command = parse_drive_command(
      R"({"lease":"t","sequence":4,"age_s":0.1,"speed_mps":0.3,"steering_rad":-0.2,"turn_rate_rad_s":0})");
  ASSERT_TRUE(command);
  EXPECT_EQ(command->sequence, 4);
  EXPECT_EQ(command->age_s, 0.1);
  EXPECT_EQ(command->command, (Command{.speed_mps = 0.3, .steering_rad = -0.2}));
}

TEST(DriveCommands, ThatMakeNoSenseAreNone) {
  for (const char* json :
       {"", "{}", "[]", R"({"lease":"t"})", R"({"lease":"t","sequence":-1})", R"({"lease":1,"sequence":1})",
        R"({"lease":"t","sequence":1,"speed_mps":"fast"})", R"({"lease":"t","sequence":1,"speed_mps":1e300})",
        R"({"lease":"t","sequence":1,"age_s":-5})", R"({"lease":"t","sequence":1.5})"})
    EXPECT_FALSE(parse_drive_command(json)) << json;
}

class CommandInbox : public testing::Test {
 protected:
  static DriveCommand command(std::uint64_t sequence, double speed_mps = 0) {
    return {.lease = "t", .sequence = sequence, .command = {.speed_mps = speed_mps}};
  }

  SetClock clock;
  DriveInbox inbox{clock};
};

TEST_F(CommandInbox, GivesTheNewestOnce) {
  inbox.put(command(1, 0.1));
  inbox.put(command(2, 0.2));
  EXPECT_EQ(inbox.take()->command.speed_mps, 0.2);
  EXPECT_FALSE(inbox.take());
}

TEST_F(CommandInbox, IgnoresOldOrRepeatedSequences) {
  EXPECT_TRUE(inbox.put(command(5)));
  EXPECT_FALSE(inbox.put(command(5)));
  EXPECT_FALSE(inbox.put(command(4)));
  EXPECT_EQ(inbox.take()->sequence, 5);
  EXPECT_FALSE(inbox.put(command(5))) << "taken is not forgotten";
}

TEST_F(CommandInbox, BeginsAgainWithEachLease) {
  inbox.put(command(5, 0.4));
  inbox.begin_lease();
  EXPECT_FALSE(inbox.take()) << "of the driver before";
  EXPECT_TRUE(inbox.put(command(1)));
}

TEST_F(CommandInbox, CountsHowLongACommandWaited) {
  inbox.put({.lease = "t", .sequence = 1, .age_s = 0.1, .command = {}});
  clock.time_s += 0.4;
  EXPECT_NEAR(inbox.take()->age_s, 0.5, 1e-9);
}

}  // namespace
}  // namespace aisle
