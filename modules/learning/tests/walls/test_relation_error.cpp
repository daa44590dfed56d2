#include <gmock/gmock.h>

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/learning/walls/relation_error.hpp"
#include "pose_matchers.hpp"

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

/// A drive in bends, half a metre a scan.
std::vector<Pose2> winding_path() {
  std::vector<Pose2> path = {{}};
  for (int i = 1; i < 120; ++i) path.push_back(path.back() * Pose2{0.5, 0, 0.4 * std::sin(0.3 * i)});
  return path;
}

/// The relative poses of a point on the vehicle, `apart` scans from each other.
std::vector<PoseRelation> relations_of(const Pose2& T_vehicle_point, std::size_t apart, double sigma_m = 0) {
  const std::vector<Pose2> path = winding_path();
  Random random(1);
  std::vector<PoseRelation> relations;
  for (std::size_t i = 0; i + apart < path.size(); ++i) {
    const Pose2 noise{random.normal(sigma_m), random.normal(sigma_m), random.normal(0.1 * sigma_m)};
    const Pose2 T_1_2 = between(path[i] * T_vehicle_point, path[i + apart] * T_vehicle_point);
    relations.push_back({i, i + apart, T_1_2 * noise});
  }
  return relations;
}

TEST(FrameOfRelations, IsThatOfTheVehicleWhereTheyAgree) {
  EXPECT_THAT(frame_of_relations(winding_path(), relations_of({}, 2)), PoseNear(Pose2{}, 0, 0));
  EXPECT_THAT(frame_of_relations(winding_path(), relations_of({}, 2, 0.05)), PoseNear(Pose2{}, 0, 0));
  EXPECT_THAT(frame_of_relations(winding_path(), relations_of({0.015, 0, 0}, 2)), PoseNear(Pose2{}, 0, 0));
}

TEST(FrameOfRelations, IsFoundWhereItIsThatOfTheLaser) {
  const Pose2 laser{0.4, -0.15, 0};
  EXPECT_THAT(frame_of_relations(winding_path(), relations_of(laser, 2)), PoseNear(laser, 1e-3, 0));
  EXPECT_THAT(frame_of_relations(winding_path(), relations_of(laser, 2, 0.02)), PoseNear(laser, 0.05, 0));
}

TEST(FrameOfRelations, LeavesNoErrorThere) {
  const Pose2 laser{0.4, -0.15, 0};
  const std::vector<PoseRelation> relations = relations_of(laser, 3);
  std::vector<Pose2> path = winding_path();
  EXPECT_GT(relation_error(path, relations).translation_m.mean, 0.1);
  const Pose2 frame = frame_of_relations(path, relations);
  for (Pose2& pose : path) pose = pose * frame;
  EXPECT_LT(relation_error(path, relations).translation_m.mean, 1e-3);
}

TEST(FrameOfRelations, LongRelationsAndFewOnesShowNoFrame) {
  const Pose2 laser{0.4, -0.15, 0};
  std::vector<PoseRelation> relations = relations_of(laser, 12);
  std::erase_if(relations,
                [](const PoseRelation& relation) { return relation.T_1_2.position().norm() < 3.1; });
  ASSERT_GT(relations.size(), 50U);
  EXPECT_THAT(frame_of_relations(winding_path(), relations), PoseNear(Pose2{}, 0, 0));
  relations = relations_of(laser, 2);
  relations.resize(10);
  EXPECT_THAT(frame_of_relations(winding_path(), relations), PoseNear(Pose2{}, 0, 0));
  EXPECT_THAT(frame_of_relations(winding_path(), {}), PoseNear(Pose2{}, 0, 0));
}

}  // namespace
}  // namespace aisle
