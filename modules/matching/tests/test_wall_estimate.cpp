#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/matching/pose_alignment.hpp"
#include "aisle/matching/wall_estimate.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

SensedSegment sensed(const Segment2& segment) {
  SensedSegment s;
  s.segment = segment;
  s.centroid = segment.midpoint();
  s.heading_rad = segment.heading();
  s.length_m = segment.length();
  s.sigma_offset_m = 0.01;
  s.sigma_heading_rad = 0.01;
  return s;
}

/// A room of 6 x 4 m around the origin, its walls seen from inside.
std::vector<SensedSegment> room() {
  const Vec2 a(-3, -2), b(3, -2), c(3, 2), d(-3, 2);
  return {sensed({a, b}), sensed({b, c}), sensed({c, d}), sensed({d, a})};
}

struct Walls {
  std::vector<WallEstimate> all;
  std::vector<int> candidates;

  void absorb_view(const std::vector<SensedSegment>& view, const Pose2& T_map_sensor) {
    for (const SensedSegment& s : view) {
      absorb(PlacedSegment(s, T_map_sensor), 0, WallUpdateParams{}, all, candidates);
    }
  }
};

TEST(Facing, FollowsTheHeadingAndKeepsTheTwoSidesOfAWallApart) {
  EXPECT_EQ(facing_of(0.05, 0.07), Facing::kEast);
  EXPECT_EQ(facing_of(kPi / 2, 0.07), Facing::kNorth);
  EXPECT_EQ(facing_of(-kPi + 0.01, 0.07), Facing::kWest);
  EXPECT_EQ(facing_of(kPi - 0.01, 0.07), Facing::kWest);
  EXPECT_EQ(facing_of(-kPi / 2, 0.07), Facing::kSouth);
  EXPECT_EQ(facing_of(0.3, 0.07), Facing::kOblique);
}

TEST(WallEstimate, TheSameViewTwiceChangesNoWall) {
  Walls walls;
  walls.absorb_view(room(), {});
  ASSERT_EQ(walls.all.size(), 4u);
  const std::vector<WallEstimate> once = walls.all;
  walls.absorb_view(room(), {});
  ASSERT_EQ(walls.all.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_THAT(walls.all[i].segment().start, PointNear(once[i].segment().start, 1e-9));
    EXPECT_THAT(walls.all[i].segment().end, PointNear(once[i].segment().end, 1e-9));
    EXPECT_EQ(walls.all[i].sightings, 2);
  }
}

TEST(WallEstimate, ASeenEndReplacesTheLimitOfSight) {
  Walls walls;
  SensedSegment part = sensed({{0, 0}, {2, 0}});
  part.start = WallEnd::kSeen;
  walls.absorb_view({part}, {});
  SensedSegment more = sensed({{1.5, 0}, {4, 0}});
  more.end = WallEnd::kSeen;
  walls.absorb_view({more}, {});
  ASSERT_EQ(walls.all.size(), 1u);
  EXPECT_EQ(walls.all[0].start, WallEnd::kSeen);
  EXPECT_EQ(walls.all[0].end, WallEnd::kSeen);
  EXPECT_NEAR(walls.all[0].length_m(), 4, 1e-9);
}

RC_GTEST_PROP(PoseAligner, FindsThePoseInARoomFromANearbyGuess, (std::uint64_t seed)) {
  Random random(seed);
  Walls walls;
  walls.absorb_view(room(), {});
  for (WallEstimate& wall : walls.all) wall.sightings = 5;
  const Pose2 truth{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-kPi, kPi)};
  std::vector<SensedSegment> view;
  for (const SensedSegment& s : room()) view.push_back(sensed(truth.inverse() * s.segment));
  const Pose2 guess{truth.x + random.uniform(-0.1, 0.1), truth.y + random.uniform(-0.1, 0.1),
                    truth.theta + random.uniform(-0.03, 0.03)};
  PoseAligner aligner(AlignmentParams{});
  const Mat3 prior = Vec3(1, 1, 1).asDiagonal();
  const Alignment found = aligner.align(view, walls.all, walls.candidates, {guess, prior}, 0.25, 10);
  RC_ASSERT(testing::Matches(PoseNear(truth, 2e-3, 1e-3))(found.T_map_sensor));
  RC_ASSERT(std::abs(found.matched_share() - 1) < 1e-9);
}

TEST(PoseAligner, ACorridorLeavesThePositionAlongItToThePrior) {
  Walls walls;
  const std::vector<SensedSegment> corridor = {sensed({{-9, -1}, {9, -1}}), sensed({{9, 1}, {-9, 1}})};
  walls.absorb_view(corridor, {});
  PoseAligner aligner(AlignmentParams{});
  const Pose2 guess{0.5, 0.05, 0};
  const Alignment found =
      aligner.align(corridor, walls.all, walls.candidates, {guess, Mat3::Identity()}, 0.25, 10);
  EXPECT_NEAR(found.T_map_sensor.x, 0.5, 1e-3);
  EXPECT_NEAR(found.T_map_sensor.y, 0, 1e-3);
  EXPECT_LT(found.wall_information(0, 0), 1e-6 * found.wall_information(1, 1));
}

/// Its error is the same in every scan: more scans add nothing.
TEST(PoseAligner, AWallLearnedWithAYawErrorDoesNotDrawTheVehicleAlongItsCorridor) {
  const std::vector<SensedSegment> corridor = {sensed({{-9, -1}, {9, -1}}), sensed({{9, 1}, {-9, 1}})};
  Walls walls;
  walls.absorb_view(corridor, {});
  walls.all[1].facing = Facing::kOblique;
  walls.all[1].set_heading(walls.all[1].heading_rad + 1 * kDegree);
  walls.all[1].anchor += Vec2(0, 0.02);
  PoseAligner aligner(AlignmentParams{});
  const Mat3 prior = Vec3(600, 1e4, 1e4).asDiagonal();
  Pose2 T_map_sensor{0.5, 0, 0};
  for (int scan = 0; scan < 100; ++scan) {
    T_map_sensor =
        aligner.align(corridor, walls.all, walls.candidates, {T_map_sensor, prior}, 0.25, 10).T_map_sensor;
  }
  EXPECT_NEAR(T_map_sensor.x, 0.5, 1e-3);
}

}  // namespace
}  // namespace aisle
