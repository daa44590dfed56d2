#include <gmock/gmock.h>

#include "aisle/merging/building_merging.hpp"
#include "aisle/merging/moved_building.hpp"
#include "drawn_building.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using drawn::known;
using drawn::Plan;
using drawn::rect;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;

const Pose2 kMiddleFrame{30, -12, kPi / 2}, kEastFrame{-5, 9, 1.2};

Building west() {
  return known(Plan(drawn::office()), rect(0, -10, 15, 10));
}
Building middle() {
  return known(Plan(drawn::office()), rect(7, -10, 23, 10));
}
Building east() {
  return known(Plan(drawn::office()), rect(14, -10, 30, 10));
}

MergedBuilding merged(const std::vector<MapPart>& parts) {
  SilentProgress progress;
  return merge_buildings(parts, {}, progress);
}

std::vector<MapPart> three_parts() {
  return {{"west", west()},
          {"middle", moved_building(middle(), kMiddleFrame.inverse())},
          {"east", moved_building(east(), kEastFrame.inverse())}};
}

TEST(BuildingMerging, ThreePartsAreTheWhole) {
  const MergedBuilding whole = merged(three_parts());
  ASSERT_TRUE(whole.building) << whole.why_refused.front();
  EXPECT_THAT(whole.T_map_part[0], PoseNear(Pose2{}, 1e-9, 1e-9));
  EXPECT_THAT(whole.T_map_part[1], PoseNear(kMiddleFrame, 0.03, 0.1 * kDegree));
  EXPECT_THAT(whole.T_map_part[2], PoseNear(kEastFrame, 0.05, 0.3 * kDegree));
  const Building office = known(Plan(drawn::office()));
  EXPECT_NEAR(whole.building->walls.length_m(), office.walls.length_m(), 0.04 * office.walls.length_m());
  EXPECT_NEAR(whole.building->floor->free_m2(), office.floor->free_m2(), 0.04 * office.floor->free_m2());
}

TEST(BuildingMerging, MapsWithAxesAreTurnedByQuarterTurnsExactly) {
  std::vector<MapPart> parts = three_parts();
  parts.pop_back();
  const MergedBuilding whole = merged(parts);
  ASSERT_TRUE(whole.building);
  EXPECT_EQ(whole.T_map_part[1].theta, kPi / 2);
  EXPECT_GT(whole.building->walls.orthogonal_share(), 0.999);
}

TEST(BuildingMerging, PlacesAndRoutesAreCarriedOverUnderNamesOfTheirOwn) {
  std::vector<MapPart> parts = three_parts();
  parts.pop_back();
  parts[0].building.places = {{"home", {1, 1, 0}}};
  parts[1].building.places = {{"home", kMiddleFrame.inverse() * Pose2{10, 1, 0}}, {"lift", {0, 0, 0}}};
  parts[1].building.routes.push_back(
      {.name = "round",
       .path = Path(std::vector{PathPiece{kMiddleFrame.inverse() * Pose2{9, 1, 0}, {3, 0}}})});
  const MergedBuilding whole = merged(parts);
  ASSERT_TRUE(whole.building);
  const std::vector<MapPlace>& places = whole.building->places;
  EXPECT_THAT(places, ElementsAre(Field(&MapPlace::name, "home"), Field(&MapPlace::name, "home (middle)"),
                                  Field(&MapPlace::name, "lift")));
  EXPECT_THAT(places[1].T_map_place, PoseNear(Pose2{10, 1, 0}, 0.03, 0.2 * kDegree));
  EXPECT_THAT(whole.building->routes[0].path.end(), PoseNear(Pose2{12, 1, 0}, 0.03, 0.2 * kDegree));
  EXPECT_THAT(whole.notes, Contains(HasSubstr("home (middle)")));
}

TEST(BuildingMerging, ALandmarkThatTwoPartsSawIsOne) {
  std::vector<MapPart> parts = three_parts();
  parts.pop_back();
  const auto landmark_at = [](const Vec2& p) {
    return Landmark{
        .p_map = p, .covariance = 1e-4 * Mat2::Identity(), .mass = 1, .sightings = 5, .passes = 1};
  };
  parts[0].building.camera = parts[1].building.camera = CameraDescription{};
  parts[0].building.landmarks.add(landmark_at({10, 0}));
  parts[1].building.landmarks.add(landmark_at(kMiddleFrame.inverse() * Vec2(10.01, 0)));
  parts[1].building.landmarks.add(landmark_at(kMiddleFrame.inverse() * Vec2(12, 0)));
  const MergedBuilding whole = merged(parts);
  ASSERT_TRUE(whole.building);
  ASSERT_EQ(whole.building->landmarks.size(), 2u);
  EXPECT_EQ(whole.building->landmarks[0].sightings, 10);
  EXPECT_NEAR(whole.building->landmarks[0].p_map.x(), 10.005, 0.02);
}

TEST(BuildingMerging, LandmarksOfAnotherCameraAreLeftOutAndSaid) {
  std::vector<MapPart> parts = three_parts();
  parts.pop_back();
  parts[0].building.camera = CameraDescription{};
  parts[0].building.landmarks.add({.p_map = {10, 0}});
  parts[1].building.camera = CameraDescription{.name = "rear"};
  parts[1].building.landmarks.add({.p_map = {3, 0}});
  const MergedBuilding whole = merged(parts);
  ASSERT_TRUE(whole.building);
  EXPECT_EQ(whole.building->landmarks.size(), 1u);
  EXPECT_THAT(whole.notes, Contains(HasSubstr("another camera")));
}

TEST(BuildingMerging, APartThatOverlapsNothingIsNamed) {
  std::vector<MapPart> parts = three_parts();
  parts.erase(parts.begin() + 1);
  parts[0].building = known(Plan(drawn::office()), rect(0, -10, 11, 10));
  parts[1].building = known(Plan(drawn::office()), rect(16, -10, 30, 10));
  const MergedBuilding whole = merged(parts);
  EXPECT_FALSE(whole.building);
  EXPECT_THAT(whole.why_refused, Contains(HasSubstr("west and east")));
}

TEST(BuildingMerging, WhatEitherSawStandingStands) {
  std::vector<MapPart> parts = three_parts();
  parts.pop_back();
  for (int x = 180; x < 184; ++x) parts[0].building.floor->set({x, 20}, Floor::kOccupied);
  const MergedBuilding whole = merged(parts);
  ASSERT_TRUE(whole.building);
  EXPECT_EQ(whole.building->floor->at(FloorCell{181, 20}), Floor::kOccupied);
  EXPECT_EQ(whole.building->floor->at(FloorCell{181, 30}), Floor::kFree);
}

}  // namespace
}  // namespace aisle
