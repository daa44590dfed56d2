#include <gtest/gtest.h>

#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/guidance/landmarks/place_consistency.hpp"
#include "corridor_run.hpp"

namespace aisle {
namespace {

constexpr SightNoise kNoise;

/// The verdict of a standing vehicle that believes to be at (5, 0) and sees images from `truth`.
Suspicion look_from(const Pose2& truth, const SightNoise& noise, std::uint64_t seed) {
  Random random(seed);
  const std::vector<CorridorLine> lines = corridor_lines(25, random);
  const LandmarkMap map = map_of(lines);
  const UncertainPose2 T_map_believed = about({5, 0, 0}, 0.01, 0.3 * kDegree);
  PlaceConsistency consistency({}, corridor_cart());
  consistency.start();
  Suspicion suspicion = Suspicion::kOpen;
  for (int i = 0; i < 100 && suspicion == Suspicion::kOpen; ++i)
    suspicion = consistency.look(map, T_map_believed, sightings_from(lines, truth, noise, &random));
  return suspicion;
}

TEST(PlaceConsistency, IsDispelledWhereTheMapsLandmarksAreSeen) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5})
    EXPECT_EQ(look_from({5.02, -0.02, 0.3 * kDegree}, kNoise, seed), Suspicion::kDispelled) << seed;
}

TEST(PlaceConsistency, IsDispelledThoughImagesMissMostLinesAndShowWrongOnes) {
  const SightNoise poor{.unseen = 0.7, .clutter = 1};
  for (const std::uint64_t seed : {1, 2, 3, 4, 5})
    EXPECT_EQ(look_from({5.02, -0.02, 0.3 * kDegree}, poor, seed), Suspicion::kDispelled) << seed;
}

TEST(PlaceConsistency, IsDispelledWhereWrongLinesAreManyButTheMapsLandmarksAreSeen) {
  const SightNoise grainy{.grain = 30};
  for (const std::uint64_t seed : {1, 2, 3, 4, 5})
    EXPECT_EQ(look_from({5.02, -0.02, 0.3 * kDegree}, grainy, seed), Suspicion::kDispelled) << seed;
}

TEST(PlaceConsistency, IsConfirmedElsewhereInTheCorridor) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    EXPECT_EQ(look_from({10, 0.1, 0}, kNoise, seed), Suspicion::kConfirmed) << seed;
    EXPECT_EQ(look_from({5, 0, kPi}, kNoise, seed), Suspicion::kConfirmed) << seed;
  }
}

TEST(PlaceConsistency, IsConfirmedElsewhereThoughSomeOfManyLinesFitSomehow) {
  const SightNoise grainy{.grain = 30};
  for (const std::uint64_t seed : {1, 2, 3, 4, 5})
    EXPECT_EQ(look_from({10, 0.1, 0}, grainy, seed), Suspicion::kConfirmed) << seed;
}

/// The verdict of a standing vehicle that believes to be at the origin, between two rows of landmarks, and
/// sees images with these floor points.
Suspicion look_at(const std::vector<Vec2>& floor_points) {
  std::vector<CorridorLine> rows;
  for (const double y : {1.0, -1.0}) {
    for (const double x : {1.5, 2.0, 2.5, 3.0}) rows.push_back({.p_map = {x, y}});
  }
  const LandmarkMap map = map_of(rows);
  std::vector<LandmarkSighting> image;
  for (const Vec2& floor_point : floor_points) image.push_back(sighting_of(floor_point, false, kNoise));
  PlaceConsistency consistency({}, corridor_cart());
  consistency.start();
  Suspicion suspicion = Suspicion::kOpen;
  for (int i = 0; i < 100 && suspicion == Suspicion::kOpen; ++i)
    suspicion = consistency.look(map, about({}, 0.01, 0.1 * kDegree), image);
  return suspicion;
}

/// Between the rows and beyond them, at least half a metre from every landmark.
const std::vector<Vec2> kElsewhere{{2, 0.4}, {2.5, -0.4}, {3, 0}, {3.6, 1.2}, {3.6, -1.2}};

std::vector<Vec2> together(std::vector<Vec2> floor_points, const std::vector<Vec2>& more) {
  floor_points.insert(floor_points.end(), more.begin(), more.end());
  return floor_points;
}

TEST(PlaceConsistency, IsDispelledThoughUnknownLinesAreSeenBesideTheExpectedOnes) {
  const std::vector<Vec2> expected{{1.5, 1}, {2, -1}, {2.5, 1}};
  EXPECT_EQ(look_at(expected), Suspicion::kDispelled);
  EXPECT_EQ(look_at(together(expected, kElsewhere)), Suspicion::kDispelled);
}

TEST(PlaceConsistency, IsConfirmedWhereExpectedLandmarksAreMissingThoughSomethingFitsWithAnOffset) {
  const std::vector<Vec2> a_hand_off{{1.5, 1.08}, {2, -0.92}, {2.5, 1.08}};
  EXPECT_EQ(look_at(together(a_hand_off, kElsewhere)), Suspicion::kConfirmed);
}

TEST(PlaceConsistency, IsDispelledByAFewLinesThatAreAllKnown) {
  const std::vector<Vec2> outermost{{2.97, 0.99}, {1.52, -1.01}};
  EXPECT_EQ(look_at(outermost), Suspicion::kDispelled);
}

TEST(PlaceConsistency, IsDispelledWhereImagesShowNothingThatContradicts) {
  EXPECT_EQ(look_from({24, 0, 0}, kNoise, 1), Suspicion::kDispelled) << "past the last line";
}

TEST(PlaceConsistency, ImagesMustFitAfterWallsHaveJumped) {
  Random random(1);
  const std::vector<CorridorLine> lines = corridor_lines(25, random);
  const LandmarkMap map = map_of(lines);
  for (const auto& [truth, answer] : {std::pair{Pose2{5, 0, 0}, Suspicion::kDispelled},
                                      std::pair{Pose2{24, 0, 0}, Suspicion::kConfirmed}}) {
    PlaceConsistency consistency({}, corridor_cart());
    consistency.start(true);
    Suspicion suspicion = Suspicion::kOpen;
    for (int i = 0; i < 100 && suspicion == Suspicion::kOpen; ++i)
      suspicion = consistency.look(map, about({5, 0, 0}, 0.01, 0.3 * kDegree),
                                   sightings_from(lines, truth, kNoise, &random));
    EXPECT_EQ(suspicion, answer);
  }
}

TEST(PlaceConsistency, StartsAgainWithEverySuspicion) {
  Random random(1);
  const std::vector<CorridorLine> lines = corridor_lines(25, random);
  const LandmarkMap map = map_of(lines);
  const UncertainPose2 T_map_believed = about({5, 0, 0}, 0.01, 0.3 * kDegree);
  PlaceConsistency consistency({}, corridor_cart());
  for (const auto& [truth, answer] : {std::pair{Pose2{10, 0.1, 0}, Suspicion::kConfirmed},
                                      std::pair{Pose2{5, 0, 0}, Suspicion::kDispelled}}) {
    consistency.start();
    Suspicion suspicion = Suspicion::kOpen;
    for (int i = 0; i < 100 && suspicion == Suspicion::kOpen; ++i)
      suspicion = consistency.look(map, T_map_believed, sightings_from(lines, truth, kNoise, &random));
    EXPECT_EQ(suspicion, answer);
  }
}

}  // namespace
}  // namespace aisle
