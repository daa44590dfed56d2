#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "aisle/core/random.hpp"
#include "polyline.hpp"

namespace aisle {
namespace {

using testing::SizeIs;

double distance_to(const std::vector<Vec2>& line, const Vec2& p) {
  double nearest = (p - line.front()).norm();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 along = line[i] - line[i - 1];
    const double share = along.squaredNorm() > 0
                             ? std::clamp((p - line[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0)
                             : 0;
    nearest = std::min(nearest, (p - line[i - 1] - share * along).norm());
  }
  return nearest;
}

TEST(Polyline, AStraightLineNeedsItsEndsOnly) {
  EXPECT_THAT(simplified({{0, 0}, {1, 0.01}, {2, 0}, {5, 0}}, 0.1), SizeIs(2));
  EXPECT_THAT(simplified({{0, 0}, {1, 0.5}, {2, 0}}, 0.1), SizeIs(3));
}

TEST(Polyline, APathOutAndBackKeepsItsFarEnd) {
  EXPECT_THAT(simplified({{0, 0}, {1, 0}, {2, 0}, {1, 0}, {0, 0}}, 0.1), SizeIs(3));
  EXPECT_THAT(simplified({}, 0.1), SizeIs(0));
}

RC_GTEST_PROP(Polyline, EveryPointStaysWithinTheTolerance, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<Vec2> points(1 + random.index(60));
  Vec2 p = Vec2::Zero();
  for (Vec2& point : points) point = p += Vec2(random.normal(), random.normal());
  const double tolerance = random.uniform(0.1, 3);
  const std::vector<Vec2> kept = simplified(points, tolerance);
  RC_ASSERT(kept.front() == points.front());
  RC_ASSERT(kept.back() == points.back());
  for (const Vec2& point : points) RC_ASSERT(distance_to(kept, point) <= tolerance + 1e-12);
}

}  // namespace
}  // namespace aisle
