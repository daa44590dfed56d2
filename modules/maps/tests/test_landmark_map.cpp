#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/maps/landmark_map.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Landmark landmark_at(const Vec2& p_map) {
  Landmark landmark;
  landmark.p_map = p_map;
  return landmark;
}

Vec2 any_place(Random& random) {
  return {random.uniform(-15, 15), random.uniform(-15, 15)};
}

LandmarkMap any_map(Random& random) {
  LandmarkMap map;
  for (std::size_t i = random.index(60); i-- > 0;) map.add(landmark_at(any_place(random)));
  return map;
}

std::vector<int> near(const LandmarkMap& map, const Vec2& p_map, double distance_m) {
  std::vector<int> indices = {77};
  map.within(p_map, distance_m, indices);
  return indices;
}

/// The same by brute force.
std::vector<int> near_one_by_one(const LandmarkMap& map, const Vec2& p_map, double distance_m) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map[i].weight > 0 && (map[i].p_map - p_map).norm() <= distance_m)
      indices.push_back(static_cast<int>(i));
  }
  return indices;
}

RC_GTEST_PROP(LandmarkMap, FindsWhatLookingAtEveryLandmarkFinds, (std::uint64_t seed)) {
  Random random(seed);
  LandmarkMap map = any_map(random);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double chance = random.uniform();
    if (chance < 0.2) map.remove(i);
    if (chance > 0.8) map.replace(i, landmark_at(any_place(random)));
  }
  const Vec2 centre = any_place(random);
  const double distance_m = random.uniform(0, 12);
  RC_ASSERT(near(map, centre, distance_m) == near_one_by_one(map, centre, distance_m));
}

TEST(LandmarkMap, ALandmarkOnTheRimIsWithin) {
  LandmarkMap map;
  map.add(landmark_at({3, 4}));
  EXPECT_THAT(near(map, {0, 0}, 5), ElementsAre(0));
  EXPECT_THAT(near(map, {0, 0}, 4.999), IsEmpty());
}

TEST(LandmarkMap, ARemovedLandmarkLeavesNoTraceAndTheOthersKeepTheirIndices) {
  LandmarkMap map;
  for (const double x : {0.0, 0.1, 0.2}) map.add(landmark_at({x, 0}));
  map.remove(1);
  EXPECT_THAT(near(map, {0, 0}, 1), ElementsAre(0, 2));
  EXPECT_EQ(map.add(landmark_at({0.1, 0})), 3U);
  EXPECT_THAT(near(map, {0, 0}, 1), ElementsAre(0, 2, 3));
}

TEST(LandmarkMap, ALandmarkThatIsReplacedIsFoundAtItsNewPlaceOnly) {
  LandmarkMap map;
  map.add(landmark_at({0, 0}));
  map.replace(0, landmark_at({40, -30}));
  EXPECT_THAT(near(map, {0, 0}, 5), IsEmpty());
  EXPECT_THAT(near(map, {40, -30}, 5), ElementsAre(0));
}

RC_GTEST_PROP(LandmarkMap, AssigningMakesTheMapThatAddingMakes, (std::uint64_t seed)) {
  Random random(seed);
  const LandmarkMap added = any_map(random);
  LandmarkMap assigned = any_map(random);
  assigned.assign(added.all());
  RC_ASSERT(assigned.size() == added.size());
  const Vec2 centre = any_place(random);
  RC_ASSERT(near(assigned, centre, 8) == near(added, centre, 8));
}

TEST(LandmarkMap, MayBeAssignedItsOwnLandmarks) {
  LandmarkMap map;
  map.add(landmark_at({1, 2}));
  map.assign(map.all());
  EXPECT_THAT(near(map, {1, 2}, 0.1), ElementsAre(0));
}

}  // namespace
}  // namespace aisle
