#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "aisle/vision/lines/landmark_sightings.hpp"
#include "drawn_room.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

std::vector<LandmarkSighting> sightings_of(const DrawnRoom& room, const LandmarkSightingParams& params = {}) {
  LandmarkDetector detector(params, room.lens, drawn_mount());
  return detector.detect(drawn(room));
}

/// A wall ahead, turned by 0.3 rad, with its middle 20 m from its start.
DrawnRoom room_with(const DrawnPanel& panel) {
  return {.tile_m = 0.3, .walls = {wall_ahead(2.5, 0.3)}, .panels = {panel}};
}

Vec2 on_wall(const DrawnRoom& room, double along_m) {
  return room.walls[0].floor_edge.start + along_m * unit(room.walls[0].floor_edge.heading());
}

void expect_sides_of_panel(const std::vector<LandmarkSighting>& sightings, const DrawnRoom& room) {
  ASSERT_THAT(sightings, SizeIs(2));
  const DrawnPanel& panel = room.panels[0];
  EXPECT_LT((sightings[0].p_vehicle - on_wall(room, panel.to_m)).norm(), 0.03);
  EXPECT_LT((sightings[1].p_vehicle - on_wall(room, panel.from_m)).norm(), 0.03);
  EXPECT_FALSE(sightings[0].brighter_right);
  EXPECT_TRUE(sightings[1].brighter_right);
}

TEST(LandmarkSightings, ADoorStandsOnTheEdgeOfTheFloor) {
  const DrawnRoom room = room_with({.from_m = 18.8, .to_m = 19.7, .bottom_m = 0, .top_m = 2.1});
  expect_sides_of_panel(sightings_of(room), room);
}

TEST(LandmarkSightings, APosterHangsOnTheWallThatStandsBeneathIt) {
  const DrawnRoom room = room_with({.from_m = 18.8, .to_m = 19.7, .bottom_m = 0.6, .top_m = 1.6});
  expect_sides_of_panel(sightings_of(room), room);
  LandmarkSightingParams standing_only;
  standing_only.hanging = false;
  EXPECT_THAT(sightings_of(room, standing_only), IsEmpty());
}

// Short lines above eye level are all that an image of a near wall shows.
TEST(LandmarkSightings, FaintNoticesOnANearWallCountWhereNothingElseIsSeen) {
  DrawnRoom room{.walls = {wall_ahead(1.3, 0)}};
  for (const double from_m : {19.4, 19.9, 20.4})
    room.panels.push_back({.from_m = from_m, .to_m = from_m + 0.25, .bottom_m = 1.1, .brightness = 140});
  EXPECT_THAT(sightings_of(room), SizeIs(6));
  LandmarkSightingParams as_if_clear;
  as_if_clear.verticals = {};
  EXPECT_THAT(sightings_of(room, as_if_clear), IsEmpty());
}

// A distorted image shows a door at the side bowed by several pixels: one of them is 3 cm on the wall.
void expect_door_at_the_side(double to_left, const CameraIntrinsics& lens, double off_max_m) {
  const double lateral_m = 1.05, from_camera_m = 2.2, width_m = 0.9;
  DrawnRoom room{.walls = {wall_ahead(lateral_m, to_left * kPi / 2)}, .lens = lens};
  const DrawnWall& wall = room.walls[0];
  const Vec2 along = unit(wall.floor_edge.heading());
  const Vec2 p_near = drawn_mount().p_vehicle_camera.head<2>() + Vec2(from_camera_m, to_left * lateral_m);
  const Vec2 p_far = p_near + Vec2(width_m, 0);
  const double near_m = along.dot(p_near - wall.floor_edge.start),
               far_m = along.dot(p_far - wall.floor_edge.start);
  room.panels = {{.from_m = std::min(near_m, far_m), .to_m = std::max(near_m, far_m), .top_m = 2.1}};
  const auto sightings = sightings_of(room);
  ASSERT_THAT(sightings, SizeIs(2));
  for (const LandmarkSighting& sighting : sightings) {
    const double off_m = std::min((sighting.p_vehicle - p_near).norm(), (sighting.p_vehicle - p_far).norm());
    EXPECT_LT(off_m, off_max_m) << sighting.p_vehicle.transpose();
  }
}

TEST(LandmarkSightings, ADoorAtTheSideStandsWhereItIsThoughTheLensBowsIt) {
  for (const double to_left : {1.0, -1.0}) expect_door_at_the_side(to_left, drawn_lens(), 0.01);
}

TEST(LandmarkSightings, ADoorAtTheSideStandsWhereItIsInAFisheyeImage) {
  for (const double to_left : {1.0, -1.0}) expect_door_at_the_side(to_left, drawn_fisheye(), 0.02);
}

TEST(LandmarkSightings, WithoutAnEdgeOfTheFloorAreNone) {
  DrawnRoom room = room_with({.from_m = 18.8, .to_m = 19.7, .bottom_m = 0.6, .top_m = 1.6});
  room.walls[0].skirting_brightness = room.walls[0].brightness = room.floor_brightness;
  EXPECT_THAT(sightings_of(room), IsEmpty());
}

TEST(LandmarkSightings, ACornerOfTheFloorIsOneIfAskedFor) {
  const DrawnWall end = wall_ahead(2.5, 0.2), right = wall_ahead(0.8, 0.2 - kPi / 2);
  DrawnRoom room{.walls = {end, right}};
  LandmarkSightingParams with_corners;
  with_corners.corners = true;
  const auto sightings = sightings_of(room, with_corners);
  ASSERT_THAT(sightings, SizeIs(1));
  const Vec2 corner =
      drawn_mount().p_vehicle_camera.head<2>() + 2.5 * unit(0.2) - 0.8 * left_normal(unit(0.2));
  EXPECT_LT((sightings[0].p_vehicle - corner).norm(), 0.02);
  EXPECT_THAT(sightings_of(room), IsEmpty());
}

TEST(LandmarkSightings, ADoorAcrossAHallTellsItsBearing) {
  DrawnRoom room{.walls = {wall_ahead(10, 0.1)}, .panels = {{.from_m = 19.2, .to_m = 20.3, .top_m = 2.1}}};
  const auto sightings = sightings_of(room);
  ASSERT_THAT(sightings, SizeIs(2));
  const Vec2 p_camera = drawn_mount().p_vehicle_camera.head<2>();
  for (const auto& [sighting, side_m] : {std::pair{sightings[0], 20.3}, std::pair{sightings[1], 19.2}}) {
    const Vec2 sight = (on_wall(room, side_m) - p_camera).normalized();
    EXPECT_NEAR(left_normal(sight).dot((sighting.p_vehicle - p_camera).normalized()), 0, 0.2 * kDegree);
    const Vec2 off = sighting.p_vehicle - on_wall(room, side_m);
    EXPECT_LT(off.dot(sighting.covariance.inverse() * off), 9) << off.transpose();
  }
}

TEST(LandmarkSightings, ADoorAcrossAHallDoesNotCountWhereANearOneIsSeen) {
  DrawnRoom room{.walls = {wall_ahead(10, 0.1), wall_ahead(1.05, -kPi / 2)},
                 .panels = {{.from_m = 19.2, .to_m = 20.3, .top_m = 2.1},
                            {.wall = 1, .from_m = 22.2, .to_m = 23.1, .top_m = 2.1}}};
  const auto sightings = sightings_of(room);
  ASSERT_THAT(sightings, SizeIs(2));
  for (const LandmarkSighting& sighting : sightings) EXPECT_NEAR(sighting.p_vehicle.y(), -1.05, 0.05);
}

TEST(LandmarkSightings, AreUncertainAlongTheLineOfSight) {
  const DrawnRoom room = room_with({.from_m = 18.8, .to_m = 19.7, .bottom_m = 0, .top_m = 2.1});
  for (const LandmarkSighting& sighting : sightings_of(room)) {
    const Vec2 sight = (sighting.p_vehicle - drawn_mount().p_vehicle_camera.head<2>()).normalized();
    const Vec2 across = left_normal(sight);
    EXPECT_GT(sight.dot(sighting.covariance * sight), 2 * across.dot(sighting.covariance * across));
  }
}

}  // namespace
}  // namespace aisle
