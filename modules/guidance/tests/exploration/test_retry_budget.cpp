#include <gtest/gtest.h>

#include "aisle/guidance/exploration/retry_budget.hpp"

namespace aisle {
namespace {

RetryBudget renewed() {
  RetryBudget retry_budget(
      {.time_s = 60, .time_s_per_m = 5, .path_m = 10, .path_factor = 2, .planning_failures = 2});
  retry_budget.renew(100, 50, 4);
  return retry_budget;
}

TEST(RetryBudget, LastsLongerForFartherTargets) {
  EXPECT_FALSE(renewed().is_over(179, 50));
  EXPECT_TRUE(renewed().is_over(181, 50));
  EXPECT_FALSE(renewed().is_over(101, 67));
  EXPECT_TRUE(renewed().is_over(101, 69));
}

/// Turning about may take ten times the target's distance.
TEST(RetryBudget, LastsForThePathThatWasFound) {
  RetryBudget retry_budget({.time_s = 10, .time_s_per_m = 2, .path_m = 5, .path_factor = 2});
  retry_budget.renew(100, 50, 1);
  EXPECT_TRUE(retry_budget.is_over(125, 54));
  EXPECT_TRUE(retry_budget.is_over(105, 65));
  retry_budget.allow(105, 54, 10);
  EXPECT_FALSE(retry_budget.is_over(125, 64));
  EXPECT_TRUE(retry_budget.is_over(136, 64));
  EXPECT_TRUE(retry_budget.is_over(125, 75));
  retry_budget.allow(110, 60, 0.1);
  EXPECT_FALSE(retry_budget.is_over(125, 64)) << "what was allowed is not taken back";
}

TEST(RetryBudget, EndsWhenPathsFailOnOneSpot) {
  RetryBudget retry_budget = renewed();
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(retry_budget.is_over(101, 51));
    retry_budget.count_failure({3, 4, 0.1 * i});
  }
  EXPECT_TRUE(retry_budget.is_over(101, 51));
  retry_budget.renew(102, 51, 4);
  EXPECT_FALSE(retry_budget.is_over(102, 51));
}

TEST(RetryBudget, ForgetsFailuresOnOtherSpots) {
  RetryBudget retry_budget = renewed();
  for (int i = 0; i < 10; ++i) retry_budget.count_failure({1.0 * i, 0, 0});
  EXPECT_FALSE(retry_budget.is_over(101, 51));
}

}  // namespace
}  // namespace aisle
