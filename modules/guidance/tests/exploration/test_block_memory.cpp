#include "aisle/guidance/exploration/block_memory.hpp"

#include <gtest/gtest.h>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr Pose2 kStopped{5, 2, 90 * kDegree};

TEST(BlockMemory, BarsThePoseJustBeyondInItsDirection) {
  BlockMemory backwards;
  backwards.note(kStopped, LegDirection::kReverse);
  EXPECT_TRUE(backwards.is_barred({5, 1.92, 90 * kDegree}));
  EXPECT_FALSE(backwards.is_barred({5, 2.08, 90 * kDegree}));
  EXPECT_FALSE(backwards.is_barred({5.05, 1.92, 90 * kDegree})) << "beside it";
  EXPECT_FALSE(backwards.is_barred({5, 1.92, 80 * kDegree})) << "turned";
  backwards.unbar();
  EXPECT_FALSE(backwards.is_barred({5, 1.92, 90 * kDegree}));
}

TEST(BlockMemory, BarsTheHeadingJustBeyondWhenItTurns) {
  BlockMemory turning;
  turning.note(kStopped, LegDirection::kLeft);
  EXPECT_TRUE(turning.is_barred({5, 2, 100 * kDegree}));
  EXPECT_FALSE(turning.is_barred({5, 2, 80 * kDegree}));
  EXPECT_FALSE(turning.is_barred({5.1, 2, 100 * kDegree}));
}

TEST(BlockMemory, CountsStopsInARowOnOneSpot) {
  BlockMemory blocks;
  EXPECT_FALSE(blocks.was_at(kStopped));
  for (int times = 1; times <= 3; ++times) {
    blocks.note(kStopped, LegDirection::kForward);
    EXPECT_EQ(blocks.times(), times);
  }
  EXPECT_TRUE(blocks.was_at({5.1, 2.1, 0}));
  blocks.note({6, 2, 0}, LegDirection::kForward);
  EXPECT_EQ(blocks.times(), 1);
  EXPECT_FALSE(blocks.was_at(kStopped));
}

TEST(BlockMemory, BlocksTheDirectionUntilThereIsNoOtherPath) {
  BlockMemory blocks;
  EXPECT_EQ(blocks.blocked_direction(), std::nullopt);
  blocks.note(kStopped, LegDirection::kReverse);
  EXPECT_EQ(blocks.blocked_direction(), LegDirection::kReverse);
  blocks.unblock_direction();
  EXPECT_EQ(blocks.blocked_direction(), std::nullopt);
  EXPECT_TRUE(blocks.was_at(kStopped));
}

}  // namespace
}  // namespace aisle
