#include "aisle/guidance/exploration/trail.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kTrailStep_m = 0.03;  // a cycle

bool everywhere(const Pose2&) {
  return true;
}

/// A vehicle that records its trail.
class OnATrail : public testing::Test {
 protected:
  void drive(const Arc& arc) {
    const int steps = static_cast<int>(std::ceil(std::abs(arc.length_m) / kTrailStep_m));
    for (int i = 0; i < steps; ++i) {
      T_map_driven_.push_back(T_map_driven_.back() * end_pose({arc.length_m / steps, arc.turn_rad / steps}));
      trail_.go_on(T_map_driven_.back(), T_map_driven_.size() - 1);
    }
  }

  void go_back(const Path& path, double path_m) {
    for (double along_m = 0; along_m < path_m; along_m += kTrailStep_m)
      trail_.go_back(path.at(along_m).T_map_path);
    trail_.go_back(path.at(path_m).T_map_path);
  }

  double off_trail_m(const Vec2& p_map) const {
    double least_m = 1e9;
    for (const Pose2& T : T_map_driven_) least_m = std::min(least_m, (T.position() - p_map).norm());
    return least_m;
  }

  Trail trail_;
  std::vector<Pose2> T_map_driven_{{1, 2, 0.3}};
};

TEST_F(OnATrail, WithoutOneThereIsNoPathBack) {
  EXPECT_TRUE(trail_.path_back({1, 2, 0.3}, 3, everywhere).empty());
}

TEST_F(OnATrail, ThePathBackIsWhatWasDrivenInReverse) {
  drive({2, 0});
  drive({1.5, 1.2});
  drive({-1, 0.8});
  const Path back = trail_.path_back(T_map_driven_.back(), 100, everywhere);
  EXPECT_NEAR(back.length_m(), 4.5, 0.1);
  for (double along_m = 0; along_m < back.length_m(); along_m += 0.1)
    EXPECT_LT(off_trail_m(back.at(along_m).T_map_path.position()), 0.04) << along_m;
  const Pose2 off = between(T_map_driven_.front(), back.end());
  EXPECT_LT(off.position().norm(), 0.06);
  EXPECT_LT(std::abs(off.theta), 3 * kDegree);
  EXPECT_GT(back.pieces().front().arc.length_m, 0) << "where it came backwards it leaves forwards";
  EXPECT_LT(back.pieces().back().arc.length_m, 0);
}

TEST_F(OnATrail, IsDrivenBackInSegmentsAndForgotten) {
  drive({3, 0});
  drive({2, -1.5});
  const Path segment = trail_.path_back(T_map_driven_.back(), 2, everywhere);
  EXPECT_NEAR(segment.length_m(), 2, 0.21);
  go_back(segment, segment.length_m());
  const Pose2 T_map_there = segment.end();
  EXPECT_NEAR(trail_.path_back(T_map_there, 100, everywhere).length_m(), 5 - segment.length_m(), 0.15);
}

TEST_F(OnATrail, IsDrivenBackToWhereThereIsClearance) {
  drive({6, 0});
  const Vec2 p_map_start = T_map_driven_.front().position();
  const auto is_roomy = [&](const Pose2& T_map) { return (T_map.position() - p_map_start).norm() < 2; };
  const Path back = trail_.path_back(T_map_driven_.back(), 1, is_roomy);
  EXPECT_NEAR(back.length_m(), 4, 0.25);
}

TEST_F(OnATrail, StillLeadsToTheStartAfterABranchHalfwayBack) {
  drive({3, 0});
  const Path back = trail_.path_back(T_map_driven_.back(), 100, everywhere);
  go_back(back, 1.5);
  T_map_driven_.push_back(back.at(1.5).T_map_path);
  drive({1, 0.9});
  const Path home = trail_.path_back(T_map_driven_.back(), 100, everywhere);
  EXPECT_NEAR(home.length_m(), 2.5, 0.1);
  EXPECT_LT((home.end().position() - T_map_driven_.front().position()).norm(), 0.06);
}

TEST_F(OnATrail, FollowsItsScansAfterALoopClosure) {
  drive({2, 0.4});
  const Pose2 T_again_map{0.5, -0.3, 0.1};
  std::vector<Pose2> T_again_driven;
  for (const Pose2& T : T_map_driven_) T_again_driven.push_back(T_again_map * T);
  trail_.lay_again(T_again_driven);
  const Path back = trail_.path_back(T_again_driven.back(), 100, everywhere);
  EXPECT_LT((back.end().position() - T_again_driven.front().position()).norm(), 0.06);
}

TEST_F(OnATrail, LeadsIntoWhereItBeganAsItLeft) {
  drive({-0.4, 0.2});
  drive({2, 0.8});
  drive({6, -1});
  const Pose2 T_map_begin = T_map_driven_[1];
  const Path in = trail_.path_to_begin(T_map_begin, T_map_driven_.back(), 1, everywhere);
  ASSERT_FALSE(in.empty());
  EXPECT_LT((in.end().position() - T_map_begin.position()).norm(), 0.06);
  EXPECT_LT(std::abs(wrap_angle(in.end().theta - T_map_begin.theta)), 3 * kDegree);
  EXPECT_GE((in.at(0).T_map_path.position() - T_map_begin.position()).norm(), 1);
  EXPECT_LT(in.length_m(), 2.4);
  for (double along_m = 0; along_m < in.length_m(); along_m += 0.1)
    EXPECT_LT(off_trail_m(in.at(along_m).T_map_path.position()), 0.04) << along_m;
}

TEST_F(OnATrail, LeadsIntoWhereItBeganFromWhereTheVehicleIsOnIt) {
  drive({3, 0.5});
  const Pose2 T_map_begin = T_map_driven_[1], T_map_vehicle = T_map_driven_[20];
  const Path in = trail_.path_to_begin(T_map_begin, T_map_vehicle, 1, everywhere);
  ASSERT_FALSE(in.empty());
  EXPECT_LT((in.at(0).T_map_path.position() - T_map_vehicle.position()).norm(), 0.12);
  EXPECT_LT((in.end().position() - T_map_begin.position()).norm(), 0.06);
}

TEST_F(OnATrail, LeadsToWhereItsBeginningIsKnownToBeNow) {
  drive({3, 0.5});
  const Pose2 T_map_begin{5, 1, 2};
  const Path in = trail_.path_to_begin(T_map_begin, {0, 0, 0}, 1, everywhere);
  ASSERT_FALSE(in.empty());
  EXPECT_LT((in.end().position() - T_map_begin.position()).norm(), 0.06);
}

TEST_F(OnATrail, DoesNotLeadInFromWhereThereIsNoClearance) {
  drive({3, 0.5});
  const auto nowhere = [](const Pose2&) { return false; };
  EXPECT_TRUE(trail_.path_to_begin(T_map_driven_[1], T_map_driven_.back(), 1, nowhere).empty());
}

}  // namespace
}  // namespace aisle
