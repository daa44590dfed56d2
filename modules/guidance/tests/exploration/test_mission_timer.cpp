#include "aisle/guidance/exploration/mission_timer.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

TEST(MissionTimer, BeginsWithItsFirstCycle) {
  MissionTimer timer(100, 10);
  timer.tick(5000);
  EXPECT_EQ(timer.since_begin_s(), 0);
  timer.tick(5100);
  EXPECT_EQ(timer.since_begin_s(), 100);
  EXPECT_FALSE(timer.is_over());
  timer.tick(5100.1);
  EXPECT_TRUE(timer.is_over());
}

TEST(MissionTimer, IsStuckAfterALongTimeWithoutProgress) {
  MissionTimer timer(100, 10);
  timer.tick(0);
  timer.tick(10);
  EXPECT_FALSE(timer.is_stuck());
  timer.tick(11);
  EXPECT_TRUE(timer.is_stuck());
  timer.note_progress();
  EXPECT_FALSE(timer.is_stuck());
  timer.tick(21);
  EXPECT_FALSE(timer.is_stuck());
  timer.tick(22);
  EXPECT_TRUE(timer.is_stuck());
}

}  // namespace
}  // namespace aisle
