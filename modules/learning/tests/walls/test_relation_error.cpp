#include <gtest/gtest.h>

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/learning/walls/relation_error.hpp"

namespace aisle {
namespace {

/// Ahead by 1 m, then a turn to the left.
const std::vector<Pose2> kTrajectory = {{0, 0, 0}, {1, 0, 0}, {1, 0, kPi / 2}};

TEST(RelationError, OfATrueTrajectoryIsNone) {
  const std::vector<PoseRelation> relations = {{0, 1, {1, 0, 0}}, {2, 0, {0, 1, -kPi / 2}}};
  const RelationError error = relation_error(kTrajectory, relations);
  EXPECT_EQ(error.count, 2U);
  EXPECT_NEAR(error.translation_m.mean, 0, 1e-12);
  EXPECT_NEAR(error.rotation_rad.mean, 0, 1e-12);
}

TEST(RelationError, MeansAndDeviationsByHand) {
  const std::vector<PoseRelation> relations = {
      {0, 1, {1, 0.3, 0}}, {0, 1, {1.4, 0.3, 0}}, {1, 2, {0, 0, kPi / 2 + 0.3}}};
  const RelationError error = relation_error(kTrajectory, relations);
  EXPECT_NEAR(error.translation_m.mean, (0.3 + 0.5 + 0) / 3, 1e-12);
  EXPECT_NEAR(error.translation_m.deviation, std::sqrt((0.09 + 0.25 - 0.64 / 3) / 2), 1e-12);
  EXPECT_NEAR(error.rotation_rad.mean, 0.1, 1e-12);
  EXPECT_NEAR(error.rotation_rad.deviation, std::sqrt(0.03), 1e-12);
}

TEST(RelationError, IsMeasuredInTheFrameOfTheRelation) {
  const std::vector<PoseRelation> relations = {{2, 1, {0.1, 0, -kPi / 2}}};
  EXPECT_NEAR(relation_error(kTrajectory, relations).translation_m.mean, 0.1, 1e-12);
}

TEST(RelationError, TurnsAreComparedTheShortWayRound) {
  const std::vector<PoseRelation> relations = {{0, 2, {1, 0, kPi / 2 - 2 * kPi + 0.01}}};
  EXPECT_NEAR(relation_error(kTrajectory, relations).rotation_rad.mean, 0.01, 1e-12);
}

TEST(RelationError, OneRelationHasNoDeviationAndNoneHasNothing) {
  const std::vector<PoseRelation> relations = {{0, 1, {2, 0, 0}}};
  EXPECT_EQ(relation_error(kTrajectory, relations).translation_m.deviation, 0);
  EXPECT_EQ(relation_error(kTrajectory, {}).count, 0U);
  EXPECT_EQ(relation_error(kTrajectory, {}).translation_m.mean, 0);
}

}  // namespace
}  // namespace aisle
