#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "aisle/core/random.hpp"
#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kCell_m = 3;

Vec2 any_point(Random& random) {
  return {random.uniform(-20, 20), random.uniform(-20, 20)};
}

std::vector<Segment2> any_walls(Random& random) {
  std::vector<Segment2> walls(random.index(30));
  for (Segment2& wall : walls) {
    const Vec2 start = any_point(random);
    const Vec2 along(random.normal(4), random.normal(4));
    wall = {start, random.uniform() < 0.5 ? Vec2(start + along) : Vec2(start.x() + along.x(), start.y())};
  }
  return walls;
}

/// Distance of the box of two corners from the nearest of many points on the segment.
double distance_m(const Segment2& wall, const Vec2& corner, const Vec2& opposite) {
  constexpr int kPoints = 400;
  const Vec2 low = corner.cwiseMin(opposite), high = corner.cwiseMax(opposite);
  double nearest_m = 1e9;
  for (int i = 0; i <= kPoints; ++i) {
    const Vec2 point = wall.start + (wall.end - wall.start) * i / kPoints;
    nearest_m = std::min(nearest_m, (point - point.cwiseMax(low).cwiseMin(high)).norm());
  }
  return nearest_m;
}

std::vector<int> found(const CellIndex& index, const Vec2& corner, const Vec2& opposite, double margin_m) {
  std::vector<int> ids = {77};
  index.query(corner, opposite, margin_m, ids);
  return ids;
}

RC_GTEST_PROP(CellIndex, FindsEverythingInTheBoxAndNothingFarFromIt, (std::uint64_t seed)) {
  Random random(seed);
  const std::vector<Segment2> walls = any_walls(random);
  CellIndex index(kCell_m);
  for (std::size_t i = 0; i < walls.size(); ++i) index.add(walls[i], static_cast<int>(i));
  const Vec2 corner = any_point(random), opposite = any_point(random);
  const double margin_m = random.uniform(0, 2);
  const std::vector<int> ids = found(index, corner, opposite, margin_m);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const bool is_found = std::binary_search(ids.begin(), ids.end(), static_cast<int>(i));
    const Vec2 margin = Vec2::Constant(margin_m);
    const Vec2 low = corner.cwiseMin(opposite) - margin, high = corner.cwiseMax(opposite) + margin;
    const double off_m = distance_m(walls[i], low, high);
    RC_ASSERT(is_found || off_m > 0);
    RC_ASSERT(!is_found || off_m < 3 * kCell_m);  // the diagonal of two cells
  }
}

RC_GTEST_PROP(CellIndex, GivesEveryIdOnceAndInOrder, (std::uint64_t seed)) {
  Random random(seed);
  const std::vector<Segment2> walls = any_walls(random);
  CellIndex index(kCell_m);
  for (std::size_t i = walls.size(); i-- > 0;) index.add(walls[i], static_cast<int>(i));
  const std::vector<int> ids = found(index, any_point(random), any_point(random), 1);
  RC_ASSERT(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end());
}

TEST(CellIndex, AddingAgainChangesNothing) {
  CellIndex index(kCell_m);
  index.add({{-1, -1}, {10, 10}}, 4);
  index.add({{-1, -1}, {10, 10}}, 4);
  EXPECT_THAT(found(index, {0, 0}, {1, 1}, 0), ElementsAre(4));
}

TEST(CellIndex, TheCornersMayBeGivenInAnyOrder) {
  CellIndex index(kCell_m);
  index.add({{-1, -1}, {-2, -2}}, 4);
  for (const Vec2& corner : {Vec2(-3, -3), Vec2(0, 0), Vec2(-3, 0), Vec2(0, -3)}) {
    EXPECT_THAT(found(index, corner, Vec2(-3, -3) - corner, 0), ElementsAre(4));
  }
}

TEST(CellIndex, IsEmptyAtFirstAndWhenCleared) {
  CellIndex index(kCell_m);
  EXPECT_THAT(found(index, {-9, -9}, {9, 9}, 0), IsEmpty());
  index.add({{0, 0}, {1, 1}}, 4);
  index.clear();
  EXPECT_THAT(found(index, {-9, -9}, {9, 9}, 0), IsEmpty());
}

}  // namespace
}  // namespace aisle
