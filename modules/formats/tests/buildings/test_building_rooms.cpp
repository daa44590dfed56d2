#include <gmock/gmock.h>

#include "aisle/core/random.hpp"
#include "aisle/vision/places/column_view.hpp"
#include "building_texts.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

/// A path of one metre to a place that is recognised by one view.
Building building_with_view(const Image& columns) {
  Building building;
  building.name = "laboratory";
  Route route{.name = "desk", .path = Path({PathPiece{{}, {1, 0}}}), .start_view = {}};
  route.room.emplace();
  route.room->brightness = {150, 2};
  route.room->views.push_back(
      {0.25, {.brightness = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}, .columns = columns}});
  building.routes.push_back(std::move(route));
  return building;
}

Image any_columns() {
  Random random(1);
  Image columns(kViewColumns, kViewBands);
  for (std::uint8_t& grey : columns.bytes) grey = static_cast<std::uint8_t>(random.index(256));
  return columns;
}

TEST(BuildingRooms, AViewIsReadAsItWasWritten) {
  const Building building = building_with_view(any_columns());
  const auto read = parse_building(building_json(building), "written");
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  ASSERT_THAT(read->routes[0].room->views, SizeIs(1));
  const StopView& view = read->routes[0].room->views[0];
  EXPECT_EQ(view.left_m, 0.25);
  EXPECT_EQ(view.seen.brightness, building.routes[0].room->views[0].seen.brightness);
  EXPECT_EQ(view.seen.columns, any_columns());
}

TEST(BuildingRooms, AViewOfAnEarlierVersionHasNoColumns) {
  const auto read = parse_building(building_json(building_with_view({})), "earlier");
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_TRUE(read->routes[0].room->views[0].seen.columns.bytes.empty());
}

TEST(BuildingRooms, ColumnsThatAreNoneAreRefusedWithWhatWouldBeRight) {
  const std::string written = building_json(building_with_view(any_columns()));
  const std::size_t first = written.find("\"columns\": [\"") + 13;
  const auto with = [&](std::size_t size, const std::string& other) {
    std::string text = written;
    return building_problems(text.replace(first, size, other));
  };
  EXPECT_EQ(with(0, ""), "");
  EXPECT_THAT(with(1, ""), AllOf(HasSubstr("columns[0]"), HasSubstr("256 digits 0-9 and a-f")));
  EXPECT_THAT(with(1, "G"), HasSubstr("columns[0]"));
  EXPECT_THAT(with(256 + 4, ""), HasSubstr("columns"));
}

}  // namespace
}  // namespace aisle
