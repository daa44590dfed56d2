#include <gmock/gmock.h>

#include <string>

#include "aisle/report/building_picture.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kCorridorStroke = "stroke:rgb(80%,10%,20%)";

/// A corridor of 10 m with a crossing in its middle.
Building any_building() {
  Building building;
  building.corridors.nodes = {{CorridorNode::Kind::kCrossing, {5, 0}}, {CorridorNode::Kind::kEnd, {0, 0}}};
  building.corridors.corridors = {{0, 1, {{5, 0}, {0, 0}}, 2}};
  building.places = {{"lift", {2, 0, 0}}};
  building.walls.walls = {Wall{.segment = {{0, 1}, {10, 1}}}};
  building.floor.emplace();
  building.floor->set({0, 0}, Floor::kFree);
  building.floor->set({10, 3}, Floor::kOccupied);
  return building;
}

TEST(BuildingPicture, ShowsTheGraphInOneColour) {
  const Building building = any_building();
  EXPECT_THAT(svg({.building = building}), HasSubstr(kCorridorStroke));
}

TEST(BuildingPicture, AnEmptyBuildingIsAnEmptyPicture) {
  const Building empty;
  EXPECT_THAT(svg({.building = empty}), Not(HasSubstr(kCorridorStroke)));
  EXPECT_THAT(png({.building = empty}), StartsWith("\x89PNG"));
}

TEST(BuildingPicture, AWallSeenOnOneTripIsFainterAndTheLegendSaysSo) {
  constexpr const char* kFaint = "stroke-opacity:0.35";
  Building building = any_building();
  EXPECT_THAT(svg({.building = building}), Not(HasSubstr(kFaint)));
  building.walls.walls.push_back({.segment = {{0, -1}, {10, -1}}, .evidence = 1});
  EXPECT_THAT(svg({.building = building}), HasSubstr(kFaint));
}

TEST(BuildingPicture, SamePictureSameBytes) {
  const Building building = any_building();
  EXPECT_EQ(svg({.building = building}), svg({.building = building}));
}

}  // namespace
}  // namespace aisle
