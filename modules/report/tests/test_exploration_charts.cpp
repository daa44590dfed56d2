#include <gmock/gmock.h>

#include "aisle/report/exploration_charts.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

ExplorationRecord there_and_back() {
  ExplorationRecord record;
  for (int i = 0; i <= 20; ++i) record.T_map_vehicle.push_back({i <= 10 ? i : 20.0 - i, 0, 0});
  record.steps = {{0, "exploring", "one-way corridor", "straight forward", 1},
                  {5, "exploring", "unexplored crossing", "forward left turn", 3},
                  {10, "retreating", "end of corridor", "straight backward", 0}};
  record.coverage = {{0, 2}, {10, 25}, {20, 25}};
  return record;
}

TEST(ExplorationCharts, DrawWithTheirAxes) {
  EXPECT_THAT(coverage_svg(there_and_back()), StartsWith("<?xml"));
  EXPECT_THAT(transducer_svg(there_and_back()), StartsWith("<?xml"));
  EXPECT_EQ(coverage_svg(there_and_back()), coverage_svg(there_and_back()));
  EXPECT_NE(transducer_svg(there_and_back()), transducer_svg({}));
}

TEST(ExplorationCharts, AnEmptyRecordIsDrawnEmpty) {
  EXPECT_THAT(coverage_svg({}), HasSubstr("</svg>"));
  EXPECT_THAT(transducer_svg({}), HasSubstr("</svg>"));
}

TEST(ExplorationCharts, StepsBeyondThePosesAreCutThere) {
  ExplorationRecord record = there_and_back();
  record.steps.push_back({1000, "exploring", "", "", 1});
  EXPECT_THAT(transducer_svg(record), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace aisle
