#include <gtest/gtest.h>

#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/maps/floor_view.hpp"

namespace aisle {
namespace {

constexpr LaserScanner kScanner{-90 * kDegree, 1 * kDegree, 30, {}};

/// What a scanner at the origin sees of a wall straight ahead, across its view.
std::vector<float> wall_ahead(double distance_m) {
  std::vector<float> ranges_m;
  for (std::size_t beam = 0; beam <= 180; ++beam) {
    const double along = std::cos(kScanner.beam_angle(beam));
    ranges_m.push_back(along > 0.05 ? static_cast<float>(distance_m / along) : 30.0F);
  }
  return ranges_m;
}

TEST(FloorView, FreeUpToTheWallAndUnknownBehindIt) {
  FloorGrid floor;
  see_floor(floor, kScanner, wall_ahead(2.02), {}, {}, {});
  EXPECT_EQ(floor.at(Vec2(1.5, 0.3)), Floor::kFree);
  EXPECT_EQ(floor.at(Vec2(2.02, 0.3)), Floor::kOccupied);
  EXPECT_EQ(floor.at(Vec2(2.2, 0.3)), Floor::kUnknown);
}

TEST(FloorView, LeavesWhatLiesBehindTheScannerUnknown) {
  FloorGrid floor;
  see_floor(floor, kScanner, wall_ahead(2), {}, {}, {});
  EXPECT_EQ(floor.at(Vec2(-0.5, 0.2)), Floor::kUnknown);
}

TEST(FloorView, TurnsWithTheVehicle) {
  FloorGrid floor;
  see_floor(floor, kScanner, wall_ahead(2.02), {}, {10, 5, kPi / 2}, {});
  EXPECT_EQ(floor.at(Vec2(10.3, 7.02)), Floor::kOccupied);
  EXPECT_EQ(floor.at(Vec2(10.3, 6)), Floor::kFree);
}

/// Such as a table's leg, which most views from far away miss.
TEST(FloorView, BeamsTooFarApartToHitAThinObstacleDoNotClearIt) {
  for (const double distance_m : {1.02, 4.02}) {
    FloorGrid before, after;
    std::vector<float> ranges_m = wall_ahead(5.52);
    const auto pass_often = [&](FloorGrid& floor) {
      for (int i = 0; i < 20; ++i) see_floor(floor, kScanner, wall_ahead(5.52), {}, {}, {});
    };
    ranges_m[90] = static_cast<float>(distance_m);
    see_floor(before, kScanner, ranges_m, {}, {}, {});
    pass_often(before);
    pass_often(after);
    see_floor(after, kScanner, ranges_m, {}, {}, {});
    const Floor there = distance_m > 2 ? Floor::kOccupied : Floor::kFree;
    EXPECT_EQ(before.at(Vec2(distance_m, 0)), there);
    EXPECT_EQ(after.at(Vec2(distance_m, 0)), there);
    EXPECT_EQ(before.at(Vec2(distance_m, 0.3)), Floor::kFree);
  }
}

/// How often a pole at (4.52, 0) counts as occupied while the scanner drives past, 4 to 5 m away: beams are 7
/// to 9 cm apart.
double share_occupied(double pole_radius_m, bool goes_away) {
  FloorGrid floor;
  const Vec2 p_pole(4.52, 0);
  int occupied = 0;
  constexpr int kViews = 60;
  for (int view = 0; view < kViews; ++view) {
    const Pose2 T_map_vehicle{0.01 * view, -0.4 + 0.013 * view, 0.003 * (view % 7)};
    std::vector<float> ranges_m(181, 29.0F);
    const Vec2 p_vehicle = T_map_vehicle.inverse() * p_pole;
    for (std::size_t beam = 0; beam <= 180; ++beam) {
      const Vec2 along = unit(kScanner.beam_angle(beam));
      const double beside_m = std::abs(along.x() * p_vehicle.y() - along.y() * p_vehicle.x());
      const bool is_there = !goes_away || view < 10;
      if (is_there && beside_m < pole_radius_m && along.dot(p_vehicle) > 0)
        ranges_m[beam] = static_cast<float>(along.dot(p_vehicle));
    }
    see_floor(floor, kScanner, ranges_m, {}, T_map_vehicle, {}, Viewpoint::kMoved);
    if (view >= 10) occupied += floor.at(p_pole) == Floor::kOccupied ? 1 : 0;
  }
  return occupied / double{kViews - 10};
}

TEST(FloorView, FromNewPlacesAPoleStaysAndAPersonWhoLeftFades) {
  EXPECT_GT(share_occupied(0.02, false), 0.9);
  EXPECT_EQ(share_occupied(0.15, false), 1);
  EXPECT_LT(share_occupied(0.15, true), 0.4);
}

/// Glass and thin things send back single beams.
TEST(FloorView, WhatNeighbouringBeamsHitOnFreeFloorIsDynamic) {
  for (const std::size_t beams : {std::size_t{1}, std::size_t{5}}) {
    FloorGrid floor;
    for (int i = 0; i < 20; ++i) see_floor(floor, kScanner, wall_ahead(5.52), {}, {}, {});
    std::vector<float> ranges_m = wall_ahead(5.52);
    for (std::size_t beam = 90; beam < 90 + beams; ++beam) ranges_m[beam] = 2.02F;
    see_floor(floor, kScanner, ranges_m, {}, {}, {});
    EXPECT_EQ(floor.is_dynamic(floor.cell_at({2.02, 0})), beams > 1);
  }
}

/// A door's jamb: the end of the wall in front hides the far side of the cell in which its face was hit.
TEST(FloorView, PassingOneSideOfACellDoesNotClearTheOther) {
  const LaserScanner fine{-10 * kDegree, 0.1 * kDegree, 30, {}};
  constexpr double kWallAhead_m = 2, kFaceBeside_m = 0.22;
  const Vec2 p_face(2.12, kFaceBeside_m), p_opening(2.12, 0.12);
  for (const bool is_hidden : {false, true}) {
    FloorGrid floor;
    floor.see_occupied(floor.cell_at(p_face));
    floor.see_occupied(floor.cell_at(p_opening));
    std::vector<float> ranges_m;
    for (std::size_t beam = 0; beam <= 200; ++beam) {
      const Vec2 along = unit(fine.beam_angle(beam));
      const bool meets_end = is_hidden && kWallAhead_m * along.y() > kFaceBeside_m * along.x();
      ranges_m.push_back(static_cast<float>((meets_end ? kWallAhead_m : 5) / along.x()));
    }
    for (int i = 0; i < 20; ++i) see_floor(floor, fine, ranges_m, {}, {}, {});
    EXPECT_EQ(floor.at(p_face), is_hidden ? Floor::kOccupied : Floor::kFree);
    EXPECT_EQ(floor.at(p_opening), Floor::kFree);
  }
}

TEST(FloorView, LeavesWhatIsNearerThanItLooksUnknown) {
  FloorGrid floor;
  const std::vector<float> near_m(181, 0.8F);
  see_floor(floor, kScanner, wall_ahead(2), near_m, {}, {});
  EXPECT_EQ(floor.at(Vec2(0.5, 0)), Floor::kUnknown);
  EXPECT_EQ(floor.at(Vec2(1, 0)), Floor::kFree);
}

TEST(FloorView, ABeamWithoutReturnSaysNothingBehindWhatStandsNearerThanItLooks) {
  const std::vector<float> near_m(181, 0.8F), nothing(181, 30.0F);
  FloorGrid floor;
  for (const double y_m : {-0.03, 0.02, 0.32}) floor.set(floor.cell_at({0.5, y_m}), Floor::kOccupied);
  see_floor(floor, kScanner, nothing, near_m, {}, {});
  EXPECT_EQ(floor.at(Vec2(1.5, 0.02)), Floor::kUnknown);
  EXPECT_EQ(floor.at(Vec2(1.5, 0.5)), Floor::kUnknown);  // between two places that were hit
  EXPECT_EQ(floor.at(Vec2(0.5, 1.5)), Floor::kFree);
}

TEST(FloorView, BumperContactIsEnteredRightBeforeTheVehicle) {
  constexpr Footprint kCart{.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6};
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    FloorGrid floor;
    const Pose2 T_map_vehicle{3, 2, 30 * kDegree};
    stand_on_floor(floor, kCart, T_map_vehicle);
    strike_floor(floor, kCart, T_map_vehicle, gear);
    const auto at = [&](double x_m, double y_m) { return floor.at(T_map_vehicle * Vec2(x_m, y_m)); };
    const double ahead_m = gear == Gear::kForward ? 0.95 : -0.25,
                 behind_m = gear == Gear::kForward ? -0.25 : 0.95;
    for (const double y_m : {-0.25, 0.0, 0.25}) {
      EXPECT_EQ(at(ahead_m + sign(gear) * 0.05, y_m), Floor::kOccupied);
      EXPECT_NE(at(ahead_m - sign(gear) * 0.05, y_m), Floor::kOccupied);
      EXPECT_NE(at(behind_m - sign(gear) * 0.05, y_m), Floor::kOccupied);
    }
  }
}

TEST(FloorView, UnusableReadingsSayNothing) {
  FloorGrid floor;
  std::vector<float> ranges_m = wall_ahead(2);
  ranges_m[90] = 0;
  see_floor(floor, kScanner, ranges_m, {}, {}, {});
  EXPECT_EQ(floor.at(Vec2(1.5, 0.01)), Floor::kUnknown);
  EXPECT_EQ(floor.at(Vec2(1.5, 0.2)), Floor::kFree);
}

TEST(FloorView, BeamsWithoutReturnDoNotLookThroughAWall) {
  for (const std::size_t lost : {1U, 2U, 3U, 20U}) {
    FloorGrid floor;
    std::vector<float> ranges_m = wall_ahead(2.02);
    std::fill_n(ranges_m.begin() + 85, lost, 30.0F);
    see_floor(floor, kScanner, ranges_m, {}, {}, {});
    const double between_rad = kScanner.beam_angle(85) + 0.5 * kScanner.angle_step_rad;
    EXPECT_EQ(floor.at(Vec2(4 * unit(between_rad))), lost == 20 ? Floor::kFree : Floor::kUnknown) << lost;
  }
}

/// The end is farther away than the scanner reaches.
TEST(FloorView, LooksAlongALongCorridor) {
  FloorGrid floor;
  std::vector<float> ranges_m = wall_ahead(29);
  std::fill_n(ranges_m.begin() + 89, 3, 30.0F);
  see_floor(floor, kScanner, ranges_m, {}, {}, {});
  EXPECT_EQ(floor.at(Vec2(5, 0)), Floor::kFree);
}

/// One beam looks past the end of a wall, into a corridor that is longer than the scanner reaches.
TEST(FloorView, LooksPastAWallIntoALongCorridor) {
  FloorGrid floor;
  std::vector<float> ranges_m = wall_ahead(5);
  std::fill(ranges_m.begin() + 91, ranges_m.end(), 8.0F);
  ranges_m[90] = 30;
  see_floor(floor, kScanner, ranges_m, {}, {}, {});
  EXPECT_EQ(floor.at(Vec2(4 * unit(kScanner.beam_angle(90)))), Floor::kFree);
}

TEST(FloorView, FloorUnderTheVehicleIsFree) {
  FloorGrid floor;
  stand_on_floor(floor, Footprint{.front_m = 0.9, .rear_m = 0.2, .width_m = 0.6}, {3, 4, kPi});
  EXPECT_EQ(floor.at(Vec2(2.2, 4.2)), Floor::kFree);
  EXPECT_EQ(floor.at(Vec2(3.4, 4)), Floor::kUnknown);
}

TEST(FloorView, FloorThatTheVehicleCoversInPartIsFreeUnlessSomethingStandsThere) {
  const Footprint footprint{.front_m = 0.92, .rear_m = 0.2, .width_m = 0.6};
  FloorGrid floor;
  floor.set(floor.cell_at({0.93, 0.1}), Floor::kOccupied);
  stand_on_floor(floor, footprint, {});
  EXPECT_EQ(floor.at(Vec2(0.93, -0.1)), Floor::kFree);
  EXPECT_EQ(floor.at(Vec2(0.93, 0.1)), Floor::kOccupied);
}

}  // namespace
}  // namespace aisle
