#include <gmock/gmock.h>

#include <sstream>

#include "aisle/core/angle.hpp"
#include "aisle/simulation/operators/true_relations.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;

/// Twice round a circle of radius 3 m, 10 cm a scan.
std::vector<Pose2> two_rounds() {
  std::vector<Pose2> poses;
  for (double angle = 0; angle < 4 * kPi; angle += 0.1 / 3) {
    const Vec2 p = 3 * unit(angle);
    poses.push_back({p.x(), p.y(), wrap_angle(angle + kPi / 2)});
  }
  return poses;
}

TEST(TrueRelations, AgreeWithTheTruePoses) {
  const std::vector<Pose2> poses = two_rounds();
  Random random(1);
  for (const PoseRelation& relation : true_relations(poses, random)) {
    EXPECT_THAT(poses[relation.scan_1] * relation.T_1_2, PoseNear(poses[relation.scan_2], 1e-9, 1e-9));
    EXPECT_LT(relation.T_1_2.position().norm(), 1.2);
  }
}

TEST(TrueRelations, JoinNeighboursAndRevisits) {
  Random random(1);
  int neighbours = 0, revisits = 0;
  for (const PoseRelation& relation : true_relations(two_rounds(), random)) {
    ++(relation.scan_2 - relation.scan_1 < 20 ? neighbours : revisits);
  }
  EXPECT_GE(neighbours, 33);  // 37.7 m in steps of about 1.1 m
  EXPECT_GE(revisits, 15);
}

TEST(TrueRelations, SameSeedSameChoice) {
  const std::vector<Pose2> poses = two_rounds();
  Random a(5), b(5);
  EXPECT_EQ(relations_text(true_relations(poses, a)), relations_text(true_relations(poses, b)));
}

TEST(TrueRelations, AVehicleThatStandsHasNone) {
  Random random(1);
  EXPECT_THAT(true_relations({}, random), IsEmpty());
  EXPECT_THAT(true_relations(std::vector<Pose2>(50), random), IsEmpty());
}

TEST(TrueRelations, TheTextHasOneRelationALine) {
  const std::vector<PoseRelation> relations = {{3, 17, {1, -0.25, kPi / 2}}};
  std::istringstream text(relations_text(relations));
  std::string comment, line;
  std::getline(text, comment);
  std::getline(text, line);
  EXPECT_EQ(comment[0], '#');
  EXPECT_EQ(line, "3 17 1.000000 -0.250000 1.570796");
}

}  // namespace
}  // namespace aisle
