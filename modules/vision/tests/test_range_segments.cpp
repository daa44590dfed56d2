#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "aisle/core/random.hpp"
#include "aisle/vision/range_segments.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr ScanGeometry kGeometry{-kPi / 2, 0.5 * kDegree, 50};
constexpr std::size_t kBeams = 361;

/// Ranges to the walls of a convex room given as half planes n.p = d around the laser.
std::vector<float> scan_of(const std::vector<std::pair<double, double>>& normals_and_distances) {
  std::vector<float> ranges_m(kBeams, 0);
  for (std::size_t k = 0; k < kBeams; ++k) {
    const Vec2 beam = unit(kGeometry.first_angle_rad + kGeometry.angle_step_rad * static_cast<double>(k));
    double nearest = 100;
    for (const auto& [normal_rad, distance_m] : normals_and_distances) {
      const double along = beam.dot(unit(normal_rad));
      if (along > 1e-9) nearest = std::min(nearest, distance_m / along);
    }
    ranges_m[k] = static_cast<float>(nearest);
  }
  return ranges_m;
}

std::vector<SensedSegment> extract(const std::vector<float>& ranges_m, const SegmentParams& params = {}) {
  RangeSegmenter segmenter(kGeometry, params);
  std::vector<SensedSegment> segments;
  segmenter.extract(ranges_m, segments);
  return segments;
}

TEST(RangeSegments, ARoomGivesItsThreeVisibleWallsWithTheLaserOnTheirLeft) {
  const auto segments = extract(scan_of({{0, 3}, {kPi / 2, 2}, {-kPi / 2, 1}}));
  ASSERT_THAT(segments, SizeIs(3));  // right wall, wall ahead, left wall, in the order of the beams
  EXPECT_NEAR(segments[0].heading_rad, 0, 1e-6);
  EXPECT_NEAR(segments[1].heading_rad, kPi / 2, 1e-3);
  EXPECT_NEAR(std::abs(segments[2].heading_rad), kPi, 1e-3);
  EXPECT_THAT(segments[1].segment.start, PointNear(Vec2(3, -1), 0.06));
  EXPECT_THAT(segments[1].segment.end, PointNear(Vec2(3, 2), 0.06));
}

TEST(RangeSegments, CornersAreTrueEndsAndTheEdgeOfTheViewIsNot) {
  const auto segments = extract(scan_of({{0, 3}, {kPi / 2, 2}, {-kPi / 2, 1}}));
  ASSERT_THAT(segments, SizeIs(3));
  EXPECT_EQ(segments[0].start, WallEnd::kUnknown);  // goes on behind the laser
  EXPECT_EQ(segments[0].end, WallEnd::kSeen);
  EXPECT_EQ(segments[1].start, WallEnd::kSeen);
  EXPECT_EQ(segments[1].end, WallEnd::kSeen);
  EXPECT_EQ(segments[2].end, WallEnd::kUnknown);
}

TEST(RangeSegments, AWallBehindANearerOneEndsOnlyWhereSightEnds) {
  std::vector<float> ranges_m = scan_of({{0, 6}});
  for (std::size_t k = 0; k < kBeams; ++k) {  // a board 1 m wide, 2 m ahead, hides the middle
    const double angle = kGeometry.first_angle_rad + kGeometry.angle_step_rad * static_cast<double>(k);
    if (std::abs(std::tan(angle)) < 0.25 && std::abs(angle) < 1)
      ranges_m[k] = static_cast<float>(2 / std::cos(angle));
    if (ranges_m[k] > 12) ranges_m[k] = 0;
  }
  const auto segments = extract(ranges_m);
  ASSERT_THAT(segments, SizeIs(3));
  EXPECT_EQ(segments[1].start, WallEnd::kSeen) << "the board's edges are seen against the wall behind";
  EXPECT_EQ(segments[1].end, WallEnd::kSeen);
  EXPECT_EQ(segments[0].end, WallEnd::kUnknown) << "the wall goes on behind the board";
  EXPECT_EQ(segments[2].start, WallEnd::kUnknown);
}

TEST(RangeSegments, ChordsOfABentWallAreMarked) {
  std::vector<float> ranges_m(kBeams, 4.0f);  // the inside of a round tower
  const auto segments = extract(ranges_m);
  ASSERT_THAT(segments, testing::Not(IsEmpty()));
  for (const SensedSegment& s : segments) EXPECT_TRUE(s.curved);
}

TEST(RangeSegments, TheShorterAPieceOfAnUnevenWallTheLessIsItsHeadingTrusted) {
  const auto ranges_m = scan_of({{0, 3}, {kPi / 2, 2}, {-kPi / 2, 1}});
  const auto even = extract(ranges_m), uneven = extract(ranges_m, {.uneven_m = 0.1});
  ASSERT_EQ(uneven.size(), even.size());
  for (std::size_t i = 0; i < even.size(); ++i) {
    EXPECT_NEAR(uneven[i].sigma_heading_rad, std::hypot(even[i].sigma_heading_rad, 0.1 / even[i].length_m),
                1e-12);
  }
}

TEST(RangeSegments, NothingUsableGivesNothing) {
  EXPECT_THAT(extract(std::vector<float>(kBeams, 0.0f)), IsEmpty());
  EXPECT_THAT(extract(std::vector<float>(kBeams, std::numeric_limits<float>::quiet_NaN())), IsEmpty());
  EXPECT_THAT(extract(std::vector<float>(kBeams, std::numeric_limits<float>::infinity())), IsEmpty());
  EXPECT_THAT(extract(std::vector<float>(kBeams, -1.0f)), IsEmpty());
  EXPECT_THAT(extract({}), IsEmpty());
}

RC_GTEST_PROP(RangeSegments, WallsOfARandomRoomAreFoundWithinTheNoise, (std::uint64_t seed)) {
  Random random(seed);
  const double turned = random.uniform(-0.7, 0.7);
  const double ahead_m = random.uniform(1, 8), left_m = random.uniform(1, 5), right_m = random.uniform(1, 5);
  std::vector<float> ranges_m =
      scan_of({{turned, ahead_m}, {turned + kPi / 2, left_m}, {turned - kPi / 2, right_m}});
  for (float& range : ranges_m) range += static_cast<float>(random.normal(0.005));
  const std::pair<double, double> walls[3] = {
      {turned - kPi / 2, right_m}, {turned, ahead_m}, {turned + kPi / 2, left_m}};
  for (const SensedSegment& s : extract(ranges_m)) {
    if (s.length_m < 0.5) continue;
    RC_ASSERT(std::abs(wrap_quarter_turn(s.heading_rad - turned)) < 4 * s.sigma_heading_rad);
    double nearest_m = 1;
    for (const auto& [normal_rad, distance_m] : walls) {
      nearest_m = std::min(nearest_m, std::abs(unit(normal_rad).dot(s.centroid) - distance_m));
    }
    RC_ASSERT(nearest_m < 4 * s.sigma_offset_m);
  }
}

}  // namespace
}  // namespace aisle
