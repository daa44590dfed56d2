#include <gmock/gmock.h>

#include <string>
#include <string_view>

#include "aisle/report/landmark_picture.hpp"
#include "text_count.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kCross = "stroke:rgb(80%,10%,20%)";
constexpr const char* kSpot = "fill:rgb(80%,10%,20%)";
constexpr const char* kSquare = "fill:rgb(5%,6%,8%)";
constexpr const char* kPlanned = "stroke:rgb(68%,71%,75%)";
constexpr const char* kTrueWalls = "stroke:rgb(55%,59%,64%)";

/// One landmark of each weight, 1 m apart.
LandmarkMap landmarks(const std::vector<double>& weights) {
  LandmarkMap map;
  for (const double weight : weights) {
    map.add({.p_map = {static_cast<double>(map.size()), 0}, .weight = weight});
  }
  return map;
}

TEST(LandmarkPicture, LandmarksAreCrossesFromWeightOneAndDotsBelow) {
  const LandmarkMap map = landmarks({0.1, 0.99, 1, 2, 5});
  const std::string document = svg({.landmarks = map});
  EXPECT_EQ(count(document, kCross), 3 + 1);  // and its symbol in the legend
  EXPECT_EQ(count(document, kSpot), 2 + 1);
}

TEST(LandmarkPicture, VanishedLandmarksAreNotDrawn) {
  LandmarkMap map = landmarks({1, 1, 1});
  map.remove(2);
  const std::string gone = svg({.landmarks = map});
  const LandmarkMap never_there = landmarks({1, 1});
  EXPECT_EQ(gone, svg({.landmarks = never_there}));
}

TEST(LandmarkPicture, SquaresMarkThePathDrivenAtEqualDistancesHoweverFineItsPosesAre) {
  const LandmarkMap map = landmarks(std::vector<double>(11, 1.0));  // 10 m: a square every 0.2 m
  const auto squares_of_a_run = [&](int poses) {
    std::vector<std::vector<Pose2>> driven(1);
    for (int i = 0; i <= poses; ++i) driven[0].push_back({10.0 * i / poses, 0, 0});
    return count(svg({.landmarks = map, .driven = driven}), kSquare) - 3;  // three in the legend
  };
  EXPECT_NEAR(squares_of_a_run(100), 51, 2);
  EXPECT_NEAR(squares_of_a_run(3000), 51, 2);
}

TEST(LandmarkPicture, AnArcIsDrawnRoundAndAStraightPathAsOneLine) {
  const LandmarkMap map = landmarks({1, 1});
  const auto document = [&](const Arc& arc) {
    const std::vector<Route> routes = {{"there", Path({{Pose2{}, arc}}), {}}};
    return svg({.landmarks = map, .routes = routes});
  };
  const std::string straight = document({4, 0}), bent = document({4, 2});
  EXPECT_EQ(count(straight, kPlanned), 1 + 1);
  EXPECT_EQ(count(bent, kPlanned), 1 + 1);
  EXPECT_GT(count(bent, " L "), count(straight, " L ") + 10);
}

TEST(LandmarkPicture, TrueWallsAreLabelledSimulatedAndShownOnlyIfGiven) {
  const LandmarkMap map = landmarks({1, 1});
  const std::vector<Segment2> walls = {{{0, 0}, {3, 0}}, {{3, 0}, {3, 2}}};
  EXPECT_THAT(svg({.landmarks = map, .true_walls = walls}), HasSubstr(kTrueWalls));
  EXPECT_THAT(svg({.landmarks = map}), Not(HasSubstr(kTrueWalls)));
}

TEST(LandmarkPicture, SamePictureSameBytesAndNothingIsAPictureToo) {
  const LandmarkMap nothing, map = landmarks({0.5, 2});
  EXPECT_EQ(svg({.landmarks = map, .title = "Two"}), svg({.landmarks = map, .title = "Two"}));
  EXPECT_EQ(png({.landmarks = map, .title = "Two"}), png({.landmarks = map, .title = "Two"}));
  EXPECT_THAT(svg({.landmarks = nothing}), StartsWith("<?xml"));
  EXPECT_THAT(png({.landmarks = nothing}), StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace aisle
