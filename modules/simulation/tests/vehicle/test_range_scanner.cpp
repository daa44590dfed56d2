#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "aisle/simulation/vehicle/range_scanner.hpp"

namespace aisle {
namespace {

using testing::Each;
using testing::FloatNear;

/// 4 m x 4 m round the origin.
World square_room() {
  World world{.name = "square room"};
  for (const Segment2& line : {Segment2{{2, -2}, {2, 2}}, Segment2{{2, 2}, {-2, 2}},
                               Segment2{{-2, 2}, {-2, -2}}, Segment2{{-2, -2}, {2, -2}}}) {
    world.walls.push_back({.floor_edge = line});
  }
  return world;
}

RangeScannerParams without_faults() {
  RangeScannerParams params;
  params.sensor.noise_sigma_m = 0;
  params.sensor.dropped_share = 0;
  return params;
}

TEST(RangeScanner, MeasuresASquareRoomFromItsCentre) {
  const RangeScanner scanner(square_room(), without_faults());
  Random random(1);
  const std::vector<float> ranges_m = scanner.scan({0, 0, 0}, random);
  ASSERT_EQ(ranges_m.size(), 180u);
  EXPECT_FLOAT_EQ(ranges_m[0], 2);        // right
  EXPECT_FLOAT_EQ(ranges_m[45], 2.83F);   // the corner, rounded to 1 cm
  EXPECT_FLOAT_EQ(ranges_m[90], 2);       // ahead
  EXPECT_FLOAT_EQ(ranges_m[120], 2.31F);  // 30 degrees to the left: 2 m / cos 30
}

TEST(RangeScanner, LooksFromWhereItIsMounted) {
  RangeScannerParams params = without_faults();
  params.laser.T_vehicle_laser.x = 0.5;
  params.laser.T_vehicle_laser.theta = 90 * kDegree;
  const RangeScanner scanner(square_room(), params);
  Random random(1);
  const std::vector<float> ranges_m = scanner.scan({0, -1, 90 * kDegree}, random);
  EXPECT_FLOAT_EQ(ranges_m[90], 2);   // the vehicle's left
  EXPECT_FLOAT_EQ(ranges_m[0], 2.5);  // the vehicle's front, from 0.5 m further north
}

TEST(RangeScanner, AnAngleOffsetTurnsTheBeamsButNotTheLog) {
  RangeScannerParams params = without_faults();
  params.sensor.angle_offset_rad = 1 * kDegree;
  Random random(1);
  const RangeScanner straight(square_room(), without_faults()), turned(square_room(), params);
  const std::vector<float> expected = straight.scan({0, 0, 0}, random),
                           ranges_m = turned.scan({0, 0, 0}, random);
  EXPECT_TRUE(std::equal(ranges_m.begin(), ranges_m.end() - 1, expected.begin() + 1));
  EXPECT_EQ(turned.description().first_angle_rad, straight.description().first_angle_rad);
}

TEST(RangeScanner, BeyondItsReachAndOnDroppedReadingsItSeesNothing) {
  RangeScannerParams params = without_faults();
  params.laser.range_max_m = 1.5;
  Random random(1);
  EXPECT_THAT(RangeScanner(square_room(), params).scan({0, 0, 0}, random), Each(1.5F));
  params.laser.range_max_m = 30;
  params.sensor.dropped_share = 1;
  EXPECT_THAT(RangeScanner(square_room(), params).scan({0, 0, 0}, random), Each(30.F));
}

TEST(RangeScanner, NoiseHasTheGivenSpread) {
  RangeScannerParams params = without_faults();
  params.sensor.beams = 4000;
  params.laser.angle_step_rad = 1e-9;
  params.laser.first_angle_rad = 0;
  params.sensor.noise_sigma_m = 0.05;
  Random random(1);
  const std::vector<float> ranges_m = RangeScanner(square_room(), params).scan({0, 0, 0}, random);
  double sum = 0, squares = 0;
  for (const float range_m : ranges_m) {
    sum += range_m - 2;
    squares += (range_m - 2) * (range_m - 2);
  }
  EXPECT_NEAR(sum / 4000, 0, 0.004);
  EXPECT_NEAR(std::sqrt(squares / 4000), 0.05, 0.003);
}

/// How many of 10 000 beams straight ahead end at each distance, to the centimetre.
std::map<int, int> ends_ahead_cm(const World& world) {
  const RangeScanner scanner(world, without_faults());
  Random random(1);
  std::map<int, int> ends;
  for (int i = 0; i < 10'000; ++i)
    ++ends[static_cast<int>(std::lround(100 * scanner.scan({0, 0, 0}, random)[90]))];
  return ends;
}

TEST(RangeScanner, SomeBeamsComeBackFromGlassAndTheOthersFromWhatIsBehind) {
  World world = square_room();
  world.walls.push_back({.floor_edge = {{1, -1}, {1, 1}}, .returns = 0.2});
  const std::map<int, int> ends = ends_ahead_cm(world);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NEAR(ends.at(100), 2000, 120);
  EXPECT_NEAR(ends.at(200), 8000, 120);
}

TEST(RangeScanner, BlackFurnitureAbsorbsTheBeamsThatDoNotComeBack) {
  World world = square_room();
  world.furniture.push_back({.centre = {1.5, 0}, .size = {1, 1}, .returns = 0});
  const int nothing_cm = static_cast<int>(std::lround(100 * without_faults().laser.range_max_m));
  EXPECT_THAT(ends_ahead_cm(world), testing::ElementsAre(testing::Pair(nothing_cm, 10'000)));
  world.furniture.push_back({.centre = {0.7, 0}, .size = {0.2, 1}});
  EXPECT_THAT(ends_ahead_cm(world), testing::ElementsAre(testing::Pair(60, 10'000))) << "it stands before";
}

}  // namespace
}  // namespace aisle
