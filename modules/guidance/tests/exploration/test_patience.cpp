#include <gtest/gtest.h>

#include "aisle/guidance/exploration/patience.hpp"

namespace aisle {
namespace {

Patience renewed() {
  Patience patience({.time_s = 60, .time_s_per_m = 5, .way_m = 10, .way_factor = 2, .hitches = 2});
  patience.renew(100, 50, 4);
  return patience;
}

TEST(Patience, LastsLongerForWhatIsFarther) {
  EXPECT_FALSE(renewed().is_over(179, 50));
  EXPECT_TRUE(renewed().is_over(181, 50));
  EXPECT_FALSE(renewed().is_over(101, 67));
  EXPECT_TRUE(renewed().is_over(101, 69));
}

/// To turn about may take ten times as far as the target is away.
TEST(Patience, LastsForTheWayThatWasFound) {
  Patience patience({.time_s = 10, .time_s_per_m = 2, .way_m = 5, .way_factor = 2});
  patience.renew(100, 50, 1);
  EXPECT_TRUE(patience.is_over(125, 54));
  EXPECT_TRUE(patience.is_over(105, 65));
  patience.allow(105, 54, 10);
  EXPECT_FALSE(patience.is_over(125, 64));
  EXPECT_TRUE(patience.is_over(136, 64));
  EXPECT_TRUE(patience.is_over(125, 75));
  patience.allow(110, 60, 0.1);
  EXPECT_FALSE(patience.is_over(125, 64)) << "what was allowed is not taken back";
}

TEST(Patience, EndsWhenWaysFailOnOneSpot) {
  Patience patience = renewed();
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(patience.is_over(101, 51));
    patience.hitch({3, 4, 0.1 * i});
  }
  EXPECT_TRUE(patience.is_over(101, 51));
  patience.renew(102, 51, 4);
  EXPECT_FALSE(patience.is_over(102, 51));
}

TEST(Patience, ForgivesWhatFailsElsewhere) {
  Patience patience = renewed();
  for (int i = 0; i < 10; ++i) patience.hitch({1.0 * i, 0, 0});
  EXPECT_FALSE(patience.is_over(101, 51));
}

}  // namespace
}  // namespace aisle
