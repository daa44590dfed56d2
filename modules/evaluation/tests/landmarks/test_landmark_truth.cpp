#include <gtest/gtest.h>

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/evaluation/landmarks/landmark_truth.hpp"

namespace aisle {
namespace {

const std::vector<VerticalEdge> kEdges = {{{0, 1}, VerticalEdgeKind::kWall},
                                          {{5, 1}, VerticalEdgeKind::kPoster}};

MapTruth map_is_world() {
  return {{{0, 0, 0}, {5, 0, 0}}, {{0, 0, 0}, {5, 0, 0}}};
}

LandmarkMap landmarks(const std::vector<std::pair<Vec2, double>>& places_and_weights) {
  LandmarkMap map;
  for (const auto& [p_map, weight] : places_and_weights) map.add({.p_map = p_map, .weight = weight});
  return map;
}

TEST(LandmarkTruth, ALandmarkIsRealIfALineStandsWithinFifteenCentimetres) {
  const LandmarkMap map = landmarks({{{0.03, 1.04}, 2}, {{5, 0.86}, 0.5}, {{5, 0.84}, 0.5}, {{2.5, 0}, 1}});
  const LandmarkTruth found = compare_with_truth(map, map_is_world(), kEdges);
  EXPECT_EQ(found.landmarks, 4);
  EXPECT_EQ(found.real, 2);
  EXPECT_EQ(found.sure, 2);
  EXPECT_EQ(found.sure_and_real, 1);
  EXPECT_NEAR(found.rms_m, std::sqrt((0.05 * 0.05 + 0.14 * 0.14) / 2), 1e-12);
}

TEST(LandmarkTruth, RemovedLandmarksDoNotCount) {
  EXPECT_EQ(compare_with_truth(landmarks({{{0, 1}, 0}}), map_is_world(), kEdges).landmarks, 0);
}

TEST(LandmarkTruth, EachLandmarkIsPlacedInTheWorldByTheNearestPoseOfTheRun) {
  // map and world differ by a turn at the run's start, by a shift at its end
  const MapTruth truth({{0, 0, 0}, {5, 0, 0}}, {{-1, 1, kPi / 2}, {5, 0.5, 0}});
  const LandmarkMap map = landmarks({{{0, -1}, 1}, {{5, 0.5}, 1}});
  const LandmarkTruth found = compare_with_truth(map, truth, kEdges);
  EXPECT_EQ(found.real, 2);
  EXPECT_NEAR(found.rms_m, 0, 1e-12);
}

TEST(LandmarkTruth, WithoutAnyRealOneTheErrorIsZero) {
  EXPECT_EQ(compare_with_truth(landmarks({{{2, 2}, 1}}), map_is_world(), kEdges).rms_m, 0);
  EXPECT_EQ(compare_with_truth(landmarks({{{2, 2}, 1}}), map_is_world(), {}).real, 0);
}

}  // namespace
}  // namespace aisle
