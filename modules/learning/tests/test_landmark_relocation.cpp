#include <gmock/gmock.h>

#include <vector>

#include "aisle/learning/landmark_relocation.hpp"
#include "corridor_trip.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr SightNoise kNoise;

/// Along the corridor's middle, both ways round.
std::vector<Pose2> places(double length_m) {
  std::vector<Pose2> tried;
  for (double x = 0; x <= length_m; x += 0.8) {
    tried.push_back({x, 0, 0});
    tried.push_back({x, 0, kPi});
  }
  return tried;
}

TEST(LandmarkRelocation, FindsItselfInAPatternThatIsUniqueWhereverItStands) {
  Random random(2);
  const std::vector<CorridorLine> lines = corridor_lines(25, random);
  const LandmarkMap map = map_of(lines);
  LandmarkRelocator relocator({}, {});
  int found = 0;
  constexpr int kTrials = 20;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Pose2 truth{random.uniform(1, 18), random.uniform(-0.3, 0.3), random.uniform(-8, 8) * kDegree};
    const auto answer = relocator.find(map, places(22), sightings_from(lines, truth, kNoise, &random));
    if (!answer) continue;
    ++found;
    EXPECT_THAT(*answer, PoseNear(truth, 0.15, 2 * kDegree)) << trial;
  }
  EXPECT_GE(found, kTrials * 3 / 4);
}

TEST(LandmarkRelocation, DoesNotGuessInAPatternThatRepeatsItself) {
  Random random(3);
  const std::vector<CorridorLine> period = corridor_lines(6, random);
  std::vector<CorridorLine> lines;
  for (int copy = 0; copy < 5; ++copy) {
    for (const CorridorLine& line : period)
      lines.push_back({line.p_map + Vec2(6.5 * copy, 0), line.brighter_right});
  }
  LandmarkRelocator relocator({}, {});
  for (const double x : {8.0, 12.0, 15.5}) {
    EXPECT_EQ(relocator.find(map_of(lines), places(30), sightings_from(lines, {x, 0, 0}, kNoise)),
              std::nullopt)
        << x;
  }
}

TEST(LandmarkRelocation, DoesNotGuessFromFewSightings) {
  Random random(4);
  const std::vector<CorridorLine> lines = corridor_lines(25, random);
  std::vector<LandmarkSighting> seen = sightings_from(lines, {5, 0, 0}, kNoise);
  seen.resize(3);
  LandmarkRelocator relocator({}, {});
  EXPECT_EQ(relocator.find(map_of(lines), places(22), seen), std::nullopt);
  EXPECT_EQ(relocator.find(map_of(lines), places(22), {}), std::nullopt);
}

TEST(LandmarkRelocation, DoesNotFindItselfInAnotherBuilding) {
  Random random(6);
  LandmarkRelocator relocator({}, {});
  for (int trial = 0; trial < 10; ++trial) {
    const std::vector<CorridorLine> here = corridor_lines(25, random), elsewhere = corridor_lines(25, random);
    EXPECT_EQ(relocator.find(map_of(elsewhere), places(22), sightings_from(here, {9, 0, 0}, kNoise)),
              std::nullopt);
  }
}

TEST(LandmarkRelocation, FindsNothingInAnEmptyMap) {
  Random random(5);
  const std::vector<CorridorLine> lines = corridor_lines(25, random);
  LandmarkRelocator relocator({}, {});
  EXPECT_EQ(relocator.find({}, places(22), sightings_from(lines, {5, 0, 0}, kNoise)), std::nullopt);
}

}  // namespace
}  // namespace aisle
