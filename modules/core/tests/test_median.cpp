#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/median.hpp"

namespace aisle {
namespace {

RC_GTEST_PROP(Median, AsManyAreSmallerAsAreLarger, ()) {
  std::vector<int> values = *rc::gen::nonEmpty<std::vector<int>>();
  const int middle = median(values);
  const auto smaller = std::count_if(values.begin(), values.end(), [&](int value) { return value < middle; });
  const auto larger = std::count_if(values.begin(), values.end(), [&](int value) { return value > middle; });
  const auto half = static_cast<std::ptrdiff_t>(values.size() / 2);
  RC_ASSERT(smaller <= half);
  RC_ASSERT(larger <= half);
  RC_ASSERT(std::count(values.begin(), values.end(), middle) > 0);
}

TEST(Median, OfAnEvenNumberIsTheUpperOne) {
  std::vector<double> values{4, 1, 3, 2};
  EXPECT_EQ(median(values), 3);
}

}  // namespace
}  // namespace aisle
