#include <gtest/gtest.h>

#include <algorithm>

#include "exploration/footprint_reach.hpp"

namespace aisle {
namespace {

VehicleDescription cart_in_reach() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6, .height_m = 1.3};
  return vehicle;
}

std::vector<Segment2> outline(std::initializer_list<Vec2> corners) {
  std::vector<Segment2> walls;
  const std::vector<Vec2> all(corners);
  for (std::size_t i = 0; i < all.size(); ++i) walls.push_back({all[i], all[(i + 1) % all.size()]});
  return walls;
}

bool has_pose_in(const std::vector<Pose2>& poses, const Vec2& low, const Vec2& high) {
  return std::any_of(poses.begin(), poses.end(), [&](const Pose2& T) {
    return T.x > low.x() && T.x < high.x() && T.y > low.y() && T.y < high.y();
  });
}

/// A corridor along x, and a passage off its middle, as wide as given.
std::vector<Segment2> corridor_with_passage(double corridor_m, double passage_m) {
  return outline({{0, 0},
                  {12, 0},
                  {12, corridor_m},
                  {6 + passage_m, corridor_m},
                  {6 + passage_m, 8},
                  {6, 8},
                  {6, corridor_m},
                  {0, corridor_m}});
}

TEST(FootprintReach, TurnsIntoAPassageWhereThereIsRoom) {
  const auto poses = poses_in_reach(corridor_with_passage(2, 1.6), cart_in_reach(), {1, 1, 0}, 0.05);
  EXPECT_TRUE(has_pose_in(poses, {6, 4}, {7.6, 8}));
}

TEST(FootprintReach, DoesNotTurnWhereADiscWouldButTheVehicleIsTooLong) {
  const auto poses = poses_in_reach(corridor_with_passage(0.85, 0.85), cart_in_reach(), {1, 0.425, 0}, 0.05);
  EXPECT_TRUE(has_pose_in(poses, {9, 0}, {11.5, 0.85}));
  EXPECT_FALSE(has_pose_in(poses, {6, 3}, {6.85, 8}));
}

TEST(FootprintReach, StaysInsideWalls) {
  const auto poses = poses_in_reach(corridor_with_passage(2, 0.5), cart_in_reach(), {1, 1, 0}, 0.05);
  EXPECT_TRUE(std::all_of(poses.begin(), poses.end(),
                          [](const Pose2& T) { return T.x > 0.2 && T.x < 11.8 && T.y > 0.2 && T.y < 1.8; }));
}

TEST(FootprintReach, BeginsAtTheStartEvenWhereTheMarginIsMissing) {
  const auto poses = poses_in_reach(corridor_with_passage(2, 1.6), cart_in_reach(), {1, 0.31, 0}, 0.05);
  EXPECT_EQ(poses.front().y, 0.31);
}

}  // namespace
}  // namespace aisle
