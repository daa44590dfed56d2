#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/geometry/dominant_direction.hpp"

namespace aisle {
namespace {

SensedSegment piece(double heading_rad, double length_m, bool curved = false) {
  SensedSegment s;
  s.heading_rad = heading_rad;
  s.length_m = length_m;
  s.curved = curved;
  return s;
}

/// The four walls of a room of 4 m x 3 m.
std::vector<SensedSegment> room_turned_by(double heading_rad) {
  std::vector<SensedSegment> room;
  for (int side = 0; side < 4; ++side) {
    room.push_back(piece(wrap_angle(heading_rad + side * kPi / 2), side % 2 == 0 ? 4 : 3));
  }
  return room;
}

RC_GTEST_PROP(DominantDirection, IsThatOfATurnedRoom, (std::uint64_t seed)) {
  const double heading_rad = Random(seed).uniform(-kPi, kPi);
  const auto frame = dominant_direction(room_turned_by(heading_rad));
  RC_ASSERT(frame.has_value());
  RC_ASSERT(std::abs(wrap_quarter_turn(frame->heading_rad - heading_rad)) < 1e-9);
  RC_ASSERT(frame->heading_rad >= -kPi / 4 && frame->heading_rad < kPi / 4);
  RC_ASSERT(std::abs(frame->share - 1) < 1e-9);
}

TEST(DominantDirection, IsTheMeanOfWallsThatNearlyAgreeByLength) {
  const auto frame = dominant_direction(std::vector{piece(1 * kDegree, 3), piece(91 * kDegree + kDegree, 1)});
  ASSERT_TRUE(frame.has_value());
  EXPECT_NEAR(to_degrees(frame->heading_rad), 1.25, 1e-9);
}

TEST(DominantDirection, ObliqueWallsOnlyLowerTheShare) {
  std::vector<SensedSegment> walls = room_turned_by(0.2);
  walls.push_back(piece(0.2 + 30 * kDegree, 6));
  const auto frame = dominant_direction(walls);
  ASSERT_TRUE(frame.has_value());
  EXPECT_NEAR(frame->heading_rad, 0.2, 1e-9);
  EXPECT_NEAR(frame->share, 14.0 / 20.0, 1e-9);
}

TEST(DominantDirection, BentWallsHaveNoVoice) {
  std::vector<SensedSegment> walls = room_turned_by(0.2);
  for (int i = 0; i < 10; ++i) walls.push_back(piece(0.7, 10, true));
  const auto frame = dominant_direction(walls);
  ASSERT_TRUE(frame.has_value());
  EXPECT_NEAR(frame->heading_rad, 0.2, 1e-9);
  EXPECT_NEAR(frame->share, 14.0 / 114.0, 1e-9);
}

TEST(DominantDirection, TooLittleWallHasNone) {
  EXPECT_FALSE(dominant_direction(std::vector<SensedSegment>{}).has_value());
  EXPECT_FALSE(dominant_direction(std::vector{piece(0, 0.7), piece(kPi / 2, 0.7)}).has_value());
  EXPECT_TRUE(dominant_direction(std::vector{piece(0, 0.8), piece(kPi / 2, 0.8)}).has_value());
}

}  // namespace
}  // namespace aisle
