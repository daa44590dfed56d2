#include <gmock/gmock.h>

#include "pose_matchers.hpp"
#include "walls/wall_drawing.hpp"

namespace aisle {
namespace {

using testing::SizeIs;

constexpr LaserScanner kLaser{-kPi / 2, kPi / 180, 30, {}};

WallEstimate wall_of(const Segment2& segment, Facing facing, int sightings) {
  WallEstimate wall;
  wall.facing = facing;
  wall.set_heading(segment.heading());
  wall.anchor = segment.midpoint();
  wall.extent = {-segment.length() / 2, segment.length() / 2};
  wall.offset_weight = 1e4;
  wall.sightings = sightings;
  return wall;
}

/// The segment seen repeatedly on a path of `metres`.
std::vector<WallSighting> seen_along(const Segment2& segment, int wall, double metres) {
  std::vector<WallSighting> sightings;
  for (double path_m = 0.1; path_m < metres; path_m += 0.5) sightings.push_back({segment, wall, path_m});
  return sightings;
}

WallMap draw(const std::vector<WallEstimate>& walls, const std::vector<WallSighting>& sightings,
             const std::vector<PlacedScan>& scans = {}) {
  return draw_walls(walls, sightings, scans, 0.5, 3);
}

const Segment2 kLong{{5, 0}, {0, 0}};  // runs west: its free side is south

TEST(WallDrawing, AWallOftenSeenIsDrawnWhole) {
  const WallMap map = draw({wall_of(kLong, Facing::kWest, 9)}, seen_along(kLong, 0, 3));
  ASSERT_THAT(map.walls, SizeIs(1));
  EXPECT_THAT(map.walls[0].segment.start, PointNear(kLong.start, 1e-9));
  EXPECT_THAT(map.walls[0].segment.end, PointNear(kLong.end, 1e-9));
  EXPECT_EQ(map.walls[0].sightings, 6);
}

TEST(WallDrawing, RepeatedSightingsWithoutMotionCountOnce) {
  std::vector<WallSighting> sightings(20, {kLong, 0, 0.1});
  const Segment2 other{{0, 9}, {5, 9}};
  for (const WallSighting& s : seen_along(other, 1, 3)) sightings.push_back(s);
  const WallMap map = draw({wall_of(kLong, Facing::kWest, 20), wall_of(other, Facing::kEast, 9)}, sightings);
  ASSERT_THAT(map.walls, SizeIs(1));
  EXPECT_NEAR(map.walls[0].segment.midpoint().y(), 9, 1e-9);
}

TEST(WallDrawing, OfADriveShorterThanALegOneSightingIsEnough) {
  EXPECT_THAT(draw({wall_of(kLong, Facing::kWest, 20)}, {{kLong, 0, 0.1}}).walls, SizeIs(1));
}

TEST(WallDrawing, TwoEstimatesOfOneWallBecomeOneSegment) {
  const Segment2 first{{3, 0.02}, {0, 0.02}}, second{{5, -0.02}, {2.5, -0.02}};
  std::vector<WallSighting> sightings = seen_along(first, 0, 3);
  for (const WallSighting& s : seen_along(second, 1, 3)) sightings.push_back(s);
  const WallMap map = draw({wall_of(first, Facing::kWest, 9), wall_of(second, Facing::kWest, 8)}, sightings);
  ASSERT_THAT(map.walls, SizeIs(1));
  EXPECT_NEAR(map.walls[0].segment.length(), 5, 0.11);
  EXPECT_NEAR(map.walls[0].segment.midpoint().y(), 0, 0.015);
}

/// A wall with a kink at x = 2: its straight part was taken for the whole, and the bent part is a wall of its
/// own.
TEST(WallDrawing, AWallWithAKinkIsDrawnOnceEverywhere) {
  const Segment2 straight{{5, 0}, {0.5, 0}}, bent{{2.5, 0.05}, {0, -0.2}};
  std::vector<WallSighting> sightings = seen_along({{5, 0}, {2, 0}}, 0, 9);
  for (const WallSighting& s : seen_along(straight, 0, 2)) sightings.push_back(s);
  for (const WallSighting& s : seen_along(bent, 1, 5)) sightings.push_back(s);
  const WallMap map =
      draw({wall_of(straight, Facing::kOblique, 15), wall_of(bent, Facing::kOblique, 9)}, sightings);
  ASSERT_THAT(map.walls, SizeIs(2));
  double drawn_m = 0;
  for (const Wall& wall : map.walls) drawn_m += wall.segment.length();
  EXPECT_NEAR(drawn_m, 5, 0.35) << "nothing is drawn twice";
}

TEST(WallDrawing, TheTwoSidesOfAWallStayTwo) {
  const Segment2 south{{5, 0}, {0, 0}}, north{{0, 0.06}, {5, 0.06}};
  std::vector<WallSighting> sightings = seen_along(south, 0, 3);
  for (const WallSighting& s : seen_along(north, 1, 3)) sightings.push_back(s);
  const WallMap map = draw({wall_of(south, Facing::kWest, 9), wall_of(north, Facing::kEast, 9)}, sightings);
  EXPECT_THAT(map.walls, SizeIs(2));
}

TEST(WallDrawing, WhereTheVehicleDroveThereIsNoWall) {
  const LaserScan blind{.ranges_m = std::vector<float>(181, 0.0f)};
  const WallMap map = draw({wall_of(kLong, Facing::kWest, 9)}, seen_along(kLong, 0, 3),
                           {{{2.5, -1, kPi / 2}, 0, &blind, kLaser}, {{2.5, 1, kPi / 2}, 2, &blind, kLaser}});
  ASSERT_THAT(map.walls, SizeIs(2));
  for (const Wall& wall : map.walls) EXPECT_NEAR(wall.segment.length(), 2.3, 0.15);
  EXPECT_EQ(map.walls[0].end, WallEnd::kSeen);
}

TEST(WallDrawing, ADoorwayThatBeamsPassIsCutOut) {
  // The vehicle passes below the wall and always sees 3 m beyond a doorway from x = 2 to x = 3.
  std::vector<LaserScan> views;
  std::vector<PlacedScan> scans;
  for (double x = 0; x <= 5; x += 0.25) {
    LaserScan view;
    for (std::size_t beam = 0; beam < 181; ++beam) {
      const Vec2 along = unit(kPi / 2 + kLaser.beam_angle(beam));
      const double until_m = along.y() > 0.05 ? 1 / along.y() : 25;
      const double at_x = x + until_m * along.x();
      view.ranges_m.push_back(
          static_cast<float>(at_x > 2 && at_x < 3 ? until_m + 3 : std::min(until_m, 25.0)));
    }
    views.push_back(view);
  }
  double x = 0;
  for (const LaserScan& view : views) {
    scans.push_back({{x, -1, kPi / 2}, x, &view, kLaser});
    x += 0.25;
  }
  const WallMap map = draw({wall_of(kLong, Facing::kWest, 9)}, seen_along(kLong, 0, 2), scans);
  ASSERT_THAT(map.walls, SizeIs(2));
  for (const Wall& wall : map.walls) EXPECT_NEAR(wall.segment.length(), 2, 0.25);
}

}  // namespace
}  // namespace aisle
