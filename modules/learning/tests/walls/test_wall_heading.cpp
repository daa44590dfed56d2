#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/learning/walls/wall_heading.hpp"

namespace aisle {
namespace {

SensedSegment piece(double heading_rad, double length_m, bool curved = false) {
  SensedSegment s;
  s.heading_rad = wrap_angle(heading_rad);
  s.length_m = length_m;
  s.sigma_heading_rad = 0.5 * kDegree;
  s.curved = curved;
  return s;
}

/// A room of 4 m x 3 m as a sensor with this heading sees it.
std::vector<SensedSegment> room_seen_from(double heading_rad) {
  std::vector<SensedSegment> room;
  for (int side = 0; side < 4; ++side)
    room.push_back(piece(side * kPi / 2 - heading_rad, side % 2 == 0 ? 4 : 3));
  return room;
}

RC_GTEST_PROP(WallHeading, IsFoundFromAnyPredictionNearby, (std::uint64_t seed)) {
  Random random(seed);
  const double heading_rad = random.uniform(-kPi, kPi);
  const double predicted_rad = heading_rad + random.uniform(-10, 10) * kDegree;
  const auto measured = heading_from_walls(room_seen_from(heading_rad), predicted_rad, 5 * kDegree);
  RC_ASSERT(measured.has_value());
  RC_ASSERT(std::abs(wrap_angle(measured->heading_rad - heading_rad)) < 1e-6);
}

TEST(WallHeading, IsTheAxisNearestToThePrediction) {
  const auto measured = heading_from_walls(room_seen_from(0.1), 0.1 + kPi / 2 + 3 * kDegree, 2 * kDegree);
  ASSERT_TRUE(measured.has_value());
  EXPECT_NEAR(measured->heading_rad, 0.1 + kPi / 2, 1e-6);
}

TEST(WallHeading, AFrameFarFromASurePredictionIsNotTaken) {
  EXPECT_FALSE(heading_from_walls(room_seen_from(0), 10 * kDegree, 1 * kDegree).has_value());
}

TEST(WallHeading, ObliqueWallsAreOutvoted) {
  std::vector<SensedSegment> walls = room_seen_from(0.3);
  walls.push_back(piece(20 * kDegree - 0.3, 5));
  const auto measured = heading_from_walls(walls, 0.3 + 2 * kDegree, 2 * kDegree);
  ASSERT_TRUE(measured.has_value());
  EXPECT_NEAR(measured->heading_rad, 0.3, 1e-3);
}

TEST(WallHeading, AScanOfWhichLessThanHalfAgreesGivesNoHeading) {
  std::vector<SensedSegment> walls = {piece(0, 3)};
  for (int i = 1; i <= 6; ++i) walls.push_back(piece(i * 13 * kDegree, 1));
  EXPECT_FALSE(heading_from_walls(walls, 0, 2 * kDegree).has_value());
}

TEST(WallHeading, BentWallsGiveNoHeading) {
  EXPECT_FALSE(
      heading_from_walls(std::vector{piece(0, 4, true), piece(kPi / 2, 4, true)}, 0, 0.1).has_value());
}

TEST(WallHeading, TooLittleWallGivesNoHeading) {
  EXPECT_FALSE(heading_from_walls(std::vector{piece(0, 1.4)}, 0, 0.1).has_value());
  EXPECT_FALSE(heading_from_walls({}, 0, 0.1).has_value());
}

TEST(WallHeading, WallsInBothDirectionsGiveASurerHeading) {
  const auto both = heading_from_walls(std::vector{piece(0, 2), piece(kPi / 2, 2)}, 0, 0.1);
  const auto one = heading_from_walls(std::vector{piece(0, 2), piece(kPi, 2)}, 0, 0.1);
  ASSERT_TRUE(both && one);
  EXPECT_LT(both->sigma_rad, one->sigma_rad);
}

TEST(WallHeading, AShortEdgeWithAVagueDirectionSaysNothing) {
  SensedSegment edge = piece(2 * kDegree, 0.6);
  EXPECT_NEAR(misfit_to_axis(edge, 0).value().off_rad, 2 * kDegree, 1e-9);
  edge.sigma_heading_rad = 5 * kDegree;
  EXPECT_FALSE(misfit_to_axis(edge, 0));
  edge.length_m = 2;
  EXPECT_TRUE(misfit_to_axis(edge, 0));
}

}  // namespace
}  // namespace aisle
