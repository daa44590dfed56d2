#include "aisle/maps/view_pattern.hpp"

#include <gtest/gtest.h>

#include <map>

namespace aisle {
namespace {

TEST(ViewPattern, Holds21PlacesFromEachOfThreeHeadings) {
  std::map<double, std::size_t> places;
  for (const ViewLane& lane : view_pattern()) places[lane.turned_rad] += lane.along_m.size();
  ASSERT_EQ(places.size(), 3U);
  for (const auto& [turned_rad, count] : places) EXPECT_EQ(count, 21U) << turned_rad;
}

TEST(ViewPattern, LanesAreTurnedAboutTheTaughtPlace) {
  const ViewLane lane{.turned_rad = 1.5707963267948966, .lateral_m = 0.2, .along_m = {}};
  EXPECT_LT((lane.at(1).position() - Vec2(-0.2, 1)).norm(), 1e-12);
}

}  // namespace
}  // namespace aisle
