#include <gtest/gtest.h>

#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/learning/landmarks/landmark_expectation.hpp"
#include "corridor_run.hpp"

namespace aisle {
namespace {

constexpr double kPlaceSigma_m = 0.02;

struct LandmarkExpectation {
  int expected = 0, seen = 0;
};

/// What a vehicle that believes it is at (5, 0) expects of the image seen from `truth`.
LandmarkExpectation expectation_from(const Pose2& truth, const SightNoise& noise, double believed_sigma_m) {
  Random random(2);
  const std::vector<CorridorLine> lines = corridor_lines(25, random);
  LandmarkExpectation expectation;
  for (const ExpectedLandmark& landmark :
       expected_landmarks(map_of(lines), about({5, 0, 0}, believed_sigma_m, 0.1 * kDegree),
                          sightings_from(lines, truth, noise, &random), kPlaceSigma_m)) {
    ++expectation.expected;
    if (landmark.is_seen) ++expectation.seen;
  }
  return expectation;
}

TEST(LandmarkExpectation, WhereTheVehicleIsNearlyAllIsSeen) {
  const LandmarkExpectation here = expectation_from({5, 0, 0}, {.unseen = 0}, 0.01);
  EXPECT_GE(here.expected, 5);
  EXPECT_GE(here.seen, here.expected * 3 / 4);
}

TEST(LandmarkExpectation, LinesOnSureLandmarksAreKnown) {
  LandmarkMap map;
  map.add({.p_map = {5, 0.6}});
  map.add({.p_map = {2.5, -0.6}, .weight = 0.4});
  const std::vector<LandmarkSighting> image{sighting_of({5.01, 0.61}, false, {}),
                                            sighting_of({5, 0.6}, true, {}), sighting_of({5, 1.2}, false, {}),
                                            sighting_of({2.5, -0.6}, false, {})};
  EXPECT_EQ(known_sightings(map, about({0, 0, 0}, 0.01, 0.1 * kDegree), image, kPlaceSigma_m), 1);
}

TEST(LandmarkExpectation, InTheImageAreThoseSeenFromHereBeforeAndInFrontOfTheCamera) {
  LandmarkMap map;
  const auto add = [&map](const Vec2& p_map, double seen_far_m) {
    map.add({.p_map = p_map, .seen_from = {-1, 0}, .seen_far_m = seen_far_m});
  };
  add({5, 0.6}, 6);
  add({5, -0.6}, 4);
  add({1, 0.6}, 6);
  add({-3, 0}, 6);
  CameraDescription camera;
  camera.mount = {.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};
  EXPECT_EQ(landmarks_in_image(map, {}, FloorInImage(camera)), 1);
  EXPECT_EQ(landmarks_in_image(map, {1.5, 0, 0}, FloorInImage(camera)), 2) << "nearer to the second";
  EXPECT_EQ(landmarks_in_image(map, {8, 0, kPi}, FloorInImage(camera)), 0) << "from behind";
}

TEST(LandmarkExpectation, OtherSightingsDoNotCount) {
  const LandmarkExpectation plain = expectation_from({5, 0, 0}, {.unseen = 0}, 0.01);
  const LandmarkExpectation grainy = expectation_from({5, 0, 0}, {.unseen = 0, .grain = 30}, 0.01);
  EXPECT_GE(grainy.seen, plain.seen);
  EXPECT_LE(grainy.expected, plain.expected + 3) << "the view reaches somewhat farther";
}

TEST(LandmarkExpectation, ElsewhereHardlyAnythingIsSeen) {
  const LandmarkExpectation elsewhere = expectation_from({10.2, 0.1, 0}, {.unseen = 0}, 0.01);
  EXPECT_GE(elsewhere.expected, 5);
  EXPECT_LE(elsewhere.seen, 1);
}

TEST(LandmarkExpectation, LandmarksSeenOnlyFromFarOrNearAreNotExpectedAtOtherDistances) {
  const LandmarkSighting behind = sighting_of({6, 0}, false, {}), left = sighting_of({2, 2}, false, {}),
                         right = sighting_of({2, -2}, false, {});
  const std::vector<LandmarkSighting> image{left, behind, right};
  const auto is_expected = [&](double near_m, double far_m) {
    LandmarkMap map;
    map.add({.p_map = {4, 0.5}, .seen_from = {-1, 0}, .seen_near_m = near_m, .seen_far_m = far_m});
    return !expected_landmarks(map, about({0, 0, 0}, 0.01, 0.1 * kDegree), image, kPlaceSigma_m).empty();
  };
  EXPECT_TRUE(is_expected(2, 5));
  EXPECT_FALSE(is_expected(4.5, 7)) << "only seen from afar";
  EXPECT_FALSE(is_expected(1, 3)) << "only seen from near by";
}

TEST(LandmarkExpectation, AnUnsurePoseAllowsLargerOffsets) {
  const Pose2 displaced{5, 0.2, 0};
  EXPECT_LE(expectation_from(displaced, {.unseen = 0}, 0.01).seen, 1);
  const LandmarkExpectation unsure = expectation_from(displaced, {.unseen = 0}, 0.2);
  EXPECT_GE(unsure.seen, unsure.expected * 3 / 4);
}

}  // namespace
}  // namespace aisle
