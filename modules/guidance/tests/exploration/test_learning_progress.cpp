#include "aisle/guidance/exploration/learning_progress.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

TEST(LearningProgress, LittleByLittleCountsOnceItIsEnough) {
  LearningProgress learning;
  EXPECT_TRUE(learning.takes_in(10, 1));
  EXPECT_FALSE(learning.takes_in(10.3, 2));
  EXPECT_TRUE(learning.takes_in(10.6, 3));
  EXPECT_FALSE(learning.takes_in(10.9, 4));
}

TEST(LearningProgress, IsIdleAfterALongPathWithoutLearning) {
  LearningProgress learning;
  learning.takes_in(10, 20);
  EXPECT_FALSE(learning.is_idle(169));
  EXPECT_TRUE(learning.is_idle(171));
}

/// In a large building the way to what is left may be long.
TEST(LearningProgress, AfterALongPathALongerOneIsAllowed) {
  LearningProgress learning;
  learning.takes_in(10, 20);
  learning.takes_in(500, 1000);
  EXPECT_FALSE(learning.is_idle(1499));
  EXPECT_TRUE(learning.is_idle(1501));
}

}  // namespace
}  // namespace aisle
