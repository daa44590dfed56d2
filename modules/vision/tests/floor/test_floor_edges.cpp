#include <gmock/gmock.h>

#include <cmath>

#include "aisle/vision/floor/floor_edges.hpp"
#include "drawn_room.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

std::vector<FloorEdge> edges_of(const DrawnRoom& room, const CameraMount& mount = drawn_mount()) {
  FloorEdgeDetector detector({}, room.lens, mount);
  return detector.detect(drawn(room, mount));
}

/// As low as on a small vehicle.
CameraMount low_mount() {
  CameraMount mount = drawn_mount();
  mount.p_vehicle_camera.z() = 0.19;
  mount.tilt_rad = 18 * kDegree;
  return mount;
}

/// How far, in the image, the edge found is from the wall's true floor edge at a share of its length.
double miss_px(const FloorEdge& edge, const DrawnWall& wall, double share) {
  const CameraModel camera(drawn_lens());
  const CameraMount mount = drawn_mount();
  const Vec2 p =
      edge.on_floor.segment.start + share * (edge.on_floor.segment.end - edge.on_floor.segment.start);
  const Vec2 along = (wall.floor_edge.end - wall.floor_edge.start).normalized();
  const Vec2 true_p = wall.floor_edge.start + along.dot(p - wall.floor_edge.start) * along;
  const auto found_px = camera.project(mount.to_camera({p.x(), p.y(), 0}));
  const auto true_px = camera.project(mount.to_camera({true_p.x(), true_p.y(), 0}));
  return found_px && true_px ? (*found_px - *true_px).norm() : 1e9;
}

/// The same where it is farthest.
double miss_px(const FloorEdge& edge, const DrawnWall& wall) {
  double worst_px = 0;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    worst_px = std::max(worst_px, miss_px(edge, wall, share));
  return worst_px;
}

TEST(FloorEdges, AreFoundToAPixelWhateverTheWallsDirection) {
  for (int heading_deg = -75; heading_deg <= 75; heading_deg += 15) {
    const DrawnWall wall = wall_ahead(1.6, heading_deg * kDegree);
    const auto edges = edges_of({.tile_m = 0.3, .walls = {wall}});
    ASSERT_THAT(edges, SizeIs(1)) << heading_deg;
    EXPECT_LT(miss_px(edges[0], wall), 1) << heading_deg;
    const SensedSegment& seen = edges[0].on_floor;
    EXPECT_LT(std::abs(wrap_angle(seen.heading_rad - wall.floor_edge.heading())), 3 * seen.sigma_heading_rad);
    EXPECT_LT(wall.floor_edge.distance(seen.centroid), 3 * seen.sigma_offset_m) << heading_deg;
    EXPECT_LT(edges[0].contrast, 0);
  }
}

TEST(FloorEdges, OfAFisheyeImageAreWhereAWallMeetsTheFloor) {
  for (int heading_deg = -75; heading_deg <= 75; heading_deg += 50) {
    const DrawnWall wall = wall_ahead(1.6, heading_deg * kDegree);
    const auto edges = edges_of({.tile_m = 0.3, .walls = {wall}, .lens = drawn_fisheye()});
    ASSERT_THAT(edges, SizeIs(1)) << heading_deg;
    const SensedSegment& seen = edges[0].on_floor;
    EXPECT_LT(std::abs(wrap_angle(seen.heading_rad - wall.floor_edge.heading())), 0.5 * kDegree)
        << heading_deg;
    EXPECT_LT(wall.floor_edge.distance(seen.centroid), 0.01) << heading_deg;
  }
}

TEST(FloorEdges, OfAWallWithoutASkirtingBoardOrWithABrightOneAreFoundToo) {
  for (const double skirting : {170.0, 220.0}) {
    DrawnWall wall = wall_ahead(2, 0.4);
    wall.skirting_brightness = skirting;
    const auto edges = edges_of({.walls = {wall}});
    ASSERT_THAT(edges, SizeIs(1)) << skirting;
    EXPECT_LT(miss_px(edges[0], wall), 1) << skirting;
  }
}

TEST(FloorEdges, RunAlongTheLowerEdgeOfASkirtingBoardThoughItsUpperEdgeIsClearer) {
  DrawnWall wall = wall_ahead(2, 70 * kDegree);
  wall.skirting_brightness = 60;
  const DrawnRoom dark_carpet{.floor_brightness = 74, .walls = {wall}};
  FloorEdgeParams without_boards;
  without_boards.board_height_m = 0;
  FloorEdgeDetector deceived(without_boards, drawn_lens(), drawn_mount());
  const auto upper_edges = deceived.detect(drawn(dark_carpet));
  ASSERT_THAT(upper_edges, SizeIs(1));
  EXPECT_GT(miss_px(upper_edges[0], wall), 5);
  const auto board_edges = edges_of(dark_carpet);
  ASSERT_THAT(board_edges, SizeIs(1));
  EXPECT_LT(miss_px(board_edges[0], wall), 1);
  EXPECT_LT(miss_px(board_edges[0], wall, 0.5), 0.25);
  EXPECT_LT(board_edges[0].contrast, 0);
}

TEST(FloorEdges, RunAlongTheLowerEdgeOfAHighBoardThoughLaserLightIsDrawnAboveIt) {
  for (const double heading_deg : {-80, -45, 0, 45, 80}) {
    DrawnWall wall = wall_ahead(2, heading_deg * kDegree);
    wall.skirting_brightness = 60;
    wall.skirting_height_m = 0.15;
    wall.laser_height_m = 0.3;
    const auto board_edges = edges_of({.floor_brightness = 74, .walls = {wall}});
    ASSERT_THAT(board_edges, Not(IsEmpty())) << heading_deg;
    for (const FloorEdge& edge : board_edges)
      EXPECT_LT(wall.floor_edge.distance(edge.on_floor.centroid), 0.05) << heading_deg;
  }
}

TEST(FloorEdges, RunAlongTheLowerEdgeOfABoardThatIsHalfAsHighAsTheCamera) {
  DrawnWall wall = wall_ahead(1, -kPi / 2);
  wall.skirting_brightness = 60;
  const auto edges = edges_of({.floor_brightness = 74, .walls = {wall}}, low_mount());
  ASSERT_THAT(edges, Not(IsEmpty()));
  for (const FloorEdge& edge : edges)
    EXPECT_LT(wall.floor_edge.distance(edge.on_floor.centroid), 0.03) << edge.on_floor.length_m;
}

TEST(FloorEdges, OfACorridorAreItsTwoSidesAndItsEnd) {
  const DrawnWall left = wall_ahead(1, kPi / 2), right = wall_ahead(1.2, -kPi / 2), end = wall_ahead(4, 0);
  const auto edges = edges_of({.tile_m = 0.3, .walls = {left, right, end}});
  ASSERT_THAT(edges, SizeIs(3));
  EXPECT_LT(miss_px(edges[0], left), 1);
  EXPECT_LT(miss_px(edges[1], end), 1);
  EXPECT_LT(miss_px(edges[2], right), 1);
}

TEST(FloorEdges, EndWhereAWallStepsBackByLittle) {
  for (const double recess_m : {0.1, 0.15}) {
    const DrawnWall wall{.floor_edge = {{3, -3}, {3, 0}}, .brightness = 100, .skirting_brightness = 100};
    const DrawnWall door{
        .floor_edge = {{3 + recess_m, 0}, {3 + recess_m, 3}}, .brightness = 60, .skirting_brightness = 60};
    const auto edges = edges_of({.walls = {wall, door}}, low_mount());
    ASSERT_THAT(edges, SizeIs(2)) << recess_m;
    for (const FloorEdge& edge : edges)
      EXPECT_LT(std::abs(wrap_angle(edge.on_floor.heading_rad - kPi / 2)), 1 * kDegree) << recess_m;
  }
}

TEST(FloorEdges, FollowTheMountOfTheCamera) {
  CameraMount mount = drawn_mount();
  mount.pan_rad = -30 * kDegree;
  mount.roll_rad = 3 * kDegree;
  mount.tilt_rad = 25 * kDegree;
  mount.p_vehicle_camera.z() = 0.7;
  const DrawnWall wall = wall_ahead(1.5, -0.5);
  const auto edges = edges_of({.walls = {wall}}, mount);
  ASSERT_THAT(edges, SizeIs(1));
  EXPECT_LT(wall.floor_edge.distance(edges[0].on_floor.centroid), 0.01);
}

TEST(FloorEdges, ATiledOrBlankFloorHasNone) {
  EXPECT_THAT(edges_of({}), IsEmpty());
  for (const double tile_m : {0.1, 0.3, 0.6}) {
    EXPECT_THAT(edges_of({.tile_m = tile_m}), IsEmpty()) << tile_m;
  }
}

TEST(FloorEdges, PaperOnTheFloorIsNone) {
  EXPECT_THAT(edges_of({.papers = {{{2.5, 0.2}, {2.5, 0.35}}}}), IsEmpty());
}

TEST(FloorEdges, PaperIsNoneEvenIfTheFloorBeyondIsNotQuiteAsBefore) {
  EXPECT_THAT(edges_of({.papers = {{{2.5, 0.2}, {2.5, 0.35}}}, .worn = {{{2.75, 0.1}, {2.85, 0.45}}}}),
              IsEmpty());
}

TEST(FloorEdges, AreWhereAWallMeetsTheFloorNotTheShadowBeforeIt) {
  for (const double brightness : {60.0, 100.0}) {
    DrawnWall wall = wall_ahead(1.2, -kPi / 2);
    wall.skirting_brightness = wall.brightness = brightness;
    const auto edges = edges_of({.shadow_m = 0.06, .walls = {wall}}, low_mount());
    ASSERT_THAT(edges, SizeIs(1)) << brightness;
    EXPECT_LT(wall.floor_edge.distance(edges[0].on_floor.centroid), 0.015) << brightness;
  }
}

TEST(FloorEdges, OfAWallBesideDoNotLeanOutThoughTheShadowBeforeItIsWiderInTheImageWhereItIsNear) {
  DrawnWall wall = wall_ahead(0.7, -kPi / 2);
  wall.skirting_brightness = wall.brightness = 118;
  for (const double shadow_m : {0.1, 0.2}) {
    const auto edges = edges_of({.shadow_m = shadow_m, .walls = {wall}}, low_mount());
    ASSERT_THAT(edges, Not(IsEmpty())) << shadow_m;
    for (const FloorEdge& edge : edges) {
      EXPECT_LT(wall.floor_edge.distance(edge.on_floor.centroid), 0.004) << shadow_m;
      EXPECT_NEAR(edge.on_floor.heading_rad, 0, 0.1 * kDegree) << shadow_m;
    }
  }
}

TEST(FloorEdges, AreLookedForBeyondWideJointsThatLeadBetweenThemAndTheCamera) {
  const CameraMount low = low_mount();
  DrawnWall left = wall_ahead(0.7, kPi / 2), right = wall_ahead(0.7, -kPi / 2);
  for (DrawnWall* wall : {&left, &right}) wall->skirting_brightness = wall->brightness = 100;
  FloorEdgeDetector hasty({}, drawn_lens(), low), patient({.looks_past = 2}, drawn_lens(), low);
  const auto length_m = [](const std::vector<FloorEdge>& edges, const DrawnWall& wall) {
    double sum_m = 0;
    for (const FloorEdge& edge : edges)
      if (wall.floor_edge.distance(edge.on_floor.centroid) < 0.03) sum_m += edge.on_floor.length_m;
    return sum_m;
  };
  for (const double joint_m : {0.01, 0.015}) {
    const Image image = drawn({.tile_m = 0.35, .joint_m = joint_m, .walls = {left, right}}, low);
    for (const DrawnWall& wall : {left, right}) {
      EXPECT_LT(length_m(hasty.detect(image), wall), 0.2) << joint_m;
      EXPECT_GT(length_m(patient.detect(image), wall), 1) << joint_m;
    }
  }
}

TEST(FloorEdges, PaperThatIsDrivenOverIsNoneEither) {
  EXPECT_THAT(edges_of({.papers = {{{2.0, -0.15}, {2.0, 0.15}}}}), IsEmpty());
}

TEST(FloorEdges, WithoutAnImageOrWithoutAFloorInViewThereAreNone) {
  FloorEdgeDetector detector({}, drawn_lens(), drawn_mount());
  EXPECT_THAT(detector.detect({}), IsEmpty());
  EXPECT_THAT(detector.detect(Image(3, 2)), IsEmpty());
  CameraMount upwards = drawn_mount();
  upwards.tilt_rad = -45 * kDegree;
  EXPECT_THAT(edges_of({.walls = {wall_ahead(1, 0)}}, upwards), IsEmpty());
  EXPECT_THROW(detector.detect(Image(640, 480, 3)), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
