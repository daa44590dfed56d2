#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/matching/pose_graph.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

Mat3 information(double sigma_m, double sigma_rad) {
  return Vec3(1 / (sigma_m * sigma_m), 1 / (sigma_m * sigma_m), 1 / (sigma_rad * sigma_rad)).asDiagonal();
}

RC_GTEST_PROP(PoseGraph, LeavesAConsistentGraphAlone, (std::uint64_t seed)) {
  Random random(seed);
  PoseGraph graph;
  std::vector<Pose2> truth;
  for (int i = 0; i < 20; ++i) {
    truth.push_back({random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3, 3)});
    graph.add_node(truth.back());
    graph.add_heading_prior(static_cast<std::size_t>(i), truth.back().theta, 0.01);
  }
  for (std::size_t i = 0; i + 1 < truth.size(); ++i) {
    graph.add_odometry({i, i + 1, between(truth[i], truth[i + 1]), information(0.05, 0.01)});
    const std::size_t j = random.index(truth.size());
    if (j != i) graph.add_loop_closure({i, j, between(truth[i], truth[j]), information(0.02, 0.005)});
  }
  graph.optimise();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    RC_ASSERT(testing::Matches(PoseNear(truth[i], 1e-6, 1e-6))(graph.pose(i)));
  }
}

/// A square of four 10 m sides, driven with 1 degree too much at every corner.
PoseGraph drifted_square() {
  PoseGraph graph;
  Pose2 pose;
  graph.add_node(pose);
  for (std::size_t i = 0; i < 4; ++i) {
    const Pose2 side{10, 0, 91 * kDegree};
    pose = pose * side;
    graph.add_node(pose);
    graph.add_odometry({i, i + 1, side, information(0.1, 2 * kDegree)});
  }
  return graph;
}

TEST(PoseGraph, ALoopClosureBringsTheEndBackToTheStart) {
  PoseGraph graph = drifted_square();
  graph.add_loop_closure({0, 4, {0, 0, 0}, information(0.01, 0.001)});
  graph.optimise(30);
  EXPECT_THAT(graph.pose(0), PoseNear(Pose2{}, 1e-9, 1e-9)) << "the first node is the frame";
  EXPECT_THAT(graph.pose(4), PoseNear(Pose2{}, 0.02, 0.01));
  EXPECT_THAT(graph.pose(2), PoseNear(Pose2{10, 10, kPi}, 0.3, 0.05));
}

TEST(PoseGraph, TakesOdometryThatIsKnownBetterLater) {
  PoseGraph graph = drifted_square();
  for (std::size_t i = 0; i < 4; ++i) graph.set_odometry(i, {10, 0, kPi / 2});
  graph.optimise(30);
  EXPECT_THAT(graph.pose(4), PoseNear(Pose2{}, 1e-6, 1e-6));
  EXPECT_THAT(graph.pose(2), PoseNear(Pose2{10, 10, kPi}, 1e-6, 1e-6));
}

TEST(PoseGraph, AWrongLoopClosureDoesNotTearTheGraph) {
  PoseGraph graph = drifted_square();
  const Pose2 before = graph.pose(2);
  graph.add_loop_closure({0, 2, {30, -30, 1}, information(0.02, 0.01)});
  graph.optimise(30);
  EXPECT_THAT(graph.pose(2), PoseNear(before, 0.5, 0.1));
}

}  // namespace
}  // namespace aisle
