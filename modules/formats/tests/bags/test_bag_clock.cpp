#include "bags/bag_clock.hpp"

#include <gmock/gmock.h>

namespace aisle {
namespace {

using testing::HasSubstr;

/// `count` messages every 0.1 s from 1000 s on, every second number, recorded 0.05 s after their stamp.
MessageStream stream_from(const std::string& topic, int count, long first_number) {
  MessageStream stream{topic, {}};
  for (int i = 0; i < count; ++i) {
    const ros::Stamp_ns stamp = ros::stamp_ns(1000 + 0.1 * i);
    stream.times.push_back({stamp, stamp + 50'000'000, first_number + 2 * i});
  }
  return stream;
}

struct Clocks {
  std::vector<MessageStream> streams{stream_from("/scan", 40, 1), stream_from("/odom", 40, 2)};
  Problems warnings = {};

  std::vector<std::vector<double>> times_s() { return stream_times_s(streams, "bag", warnings); }
};

TEST(BagClock, StampsAreTheClockHoweverOldTheyAre) {
  Clocks clocks;
  for (MessageStream& stream : clocks.streams) {
    for (MessageTime& time : stream.times) time.log_stamp += ros::stamp_ns(8 * 86400);
  }
  const auto times_s = clocks.times_s();
  EXPECT_NEAR(times_s[0][7], 1000.7, 1e-9);
  EXPECT_NEAR(times_s[1][7], 1000.7, 1e-9);
  EXPECT_EQ(to_string(clocks.warnings), "");
}

TEST(BagClock, AStreamOfAnotherClockIsShifted) {
  Clocks clocks;
  for (MessageTime& time : clocks.streams[1].times) time.stamp += ros::stamp_ns(79.7);
  const auto times_s = clocks.times_s();
  EXPECT_NEAR(times_s[1][7], 1000.7, 1e-6);
  EXPECT_THAT(to_string(clocks.warnings),
              HasSubstr("/odom: is recorded -79.65 s after its stamps, /scan 0.05 s: two clocks"));
}

TEST(BagClock, WithoutStampsTheTimeOfRecordingIsTaken) {
  Clocks clocks;
  for (MessageTime& time : clocks.streams[1].times) time.stamp = 0;
  const auto times_s = clocks.times_s();
  EXPECT_NEAR(times_s[1][7], 1000.75, 1e-6);
  EXPECT_THAT(to_string(clocks.warnings), HasSubstr("/odom: 40 of 40 messages have no stamp"));
}

/// Both clocks or only that of the headers are set by `jump_s` after the 20th message.
Clocks set_clocks(double jump_s, bool log_too) {
  Clocks clocks;
  const auto jump = static_cast<ros::Stamp_ns>(jump_s * 1e9);
  for (MessageStream& stream : clocks.streams) {
    for (std::size_t i = 20; i < stream.times.size(); ++i) {
      stream.times[i].stamp += jump;
      if (log_too) stream.times[i].log_stamp += jump;
    }
  }
  return clocks;
}

TEST(BagClock, AClockThatWasSetGoesOnForAllStreamsAlike) {
  for (const bool log_too : {true, false}) {
    for (const double jump_s : {-900.0, -1.0}) {
      Clocks clocks = set_clocks(jump_s, log_too);
      const auto times_s = clocks.times_s();
      EXPECT_NEAR(times_s[0].back(), 1003.9, 1e-6) << jump_s;
      EXPECT_NEAR(times_s[1].back(), 1003.9, 1e-6) << jump_s;
      EXPECT_THAT(to_string(clocks.warnings), HasSubstr("bag:41: /scan: the clock jumps here by "));
    }
  }
  Clocks forward = set_clocks(900, false);
  EXPECT_NEAR(forward.times_s()[0].back(), 1003.9, 1e-6);
}

TEST(BagClock, AStepForwardThatTheRecorderSawIsAGap) {
  Clocks clocks = set_clocks(900, true);
  EXPECT_NEAR(clocks.times_s()[0].back(), 1903.9, 1e-6);
  EXPECT_THAT(to_string(clocks.warnings), HasSubstr("bag:39: /scan: nothing for 900.1 s after this message"));
}

TEST(BagClock, MessagesInTheWrongOrderDoNotTurnTimeBack) {
  Clocks clocks;
  std::swap(clocks.streams[0].times[7].stamp, clocks.streams[0].times[8].stamp);
  const auto times_s = clocks.times_s();
  for (std::size_t i = 1; i < times_s[0].size(); ++i) EXPECT_GE(times_s[0][i], times_s[0][i - 1]);
  EXPECT_NEAR(times_s[0].back(), 1003.9, 1e-6);
  EXPECT_THAT(to_string(clocks.warnings), HasSubstr("1 stamps are older than the one before"));
}

}  // namespace
}  // namespace aisle
