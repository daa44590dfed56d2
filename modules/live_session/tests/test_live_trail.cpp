#include "live_trail.hpp"

#include <gtest/gtest.h>

#include "aisle/formats/sessions/cdr.hpp"

namespace aisle {
namespace {

ros::Pose turned(double x, double y, double heading_rad) {
  return {{.x = x, .y = y}, {.z = std::sin(heading_rad / 2), .w = std::cos(heading_rad / 2)}};
}

class Trail : public testing::Test {
 protected:
  void odometry(double x, double y, double heading_rad = 0) {
    ros::Odometry message;
    message.pose.pose = turned(x, y, heading_rad);
    trail.take({"/odom", ros::Odometry::kType}, cdr_bytes(message));
  }
  void pose(double x, double y, double heading_rad = 0) {
    ros::PoseWithCovarianceStamped message;
    message.pose.pose = turned(x, y, heading_rad);
    trail.take({"/pose", ros::PoseWithCovarianceStamped::kType}, cdr_bytes(message));
  }

  LiveTrail trail;
};

TEST_F(Trail, HasAPointEveryTenthOfAMetre) {
  odometry(0, 0);
  odometry(0.05, 0);
  odometry(0.12, 0);
  odometry(0.12, 0.5);
  EXPECT_EQ(trail.json().dump(), R"({"points":[[0.0,0.0],[0.12,0.0],[0.12,0.5]]})");
  EXPECT_NEAR(trail.distance_m(), 0.62, 1e-9);
}

TEST_F(Trail, FollowsThePoseWhereOneIsTold) {
  odometry(9, 9);
  pose(1, 1);
  odometry(7, 7);
  pose(1, 2);
  EXPECT_EQ(trail.json().dump(), R"({"points":[[1.0,1.0],[1.0,2.0]]})");
}

TEST_F(Trail, GoesOnOnTheSameMapWhereTheVehicleStands) {
  pose(2, 1, kPi / 2);
  trail.go_on();
  ASSERT_TRUE(trail.T_map_odom());
  EXPECT_EQ(pose_json(*trail.T_map_odom()).dump(), R"({"x_m":2.0,"y_m":1.0,"heading_deg":90.0})");
  odometry(0.5, 0);
  EXPECT_EQ(trail.json().dump(), R"({"points":[[2.0,1.0],[2.0,1.5]]})");
}

TEST_F(Trail, OfANewMissionIsEmpty) {
  pose(2, 1);
  trail.begin();
  trail.go_on();
  EXPECT_FALSE(trail.T_map_odom());
  EXPECT_EQ(trail.json().dump(), R"({"points":[]})");
  EXPECT_EQ(trail.distance_m(), 0);
}

TEST_F(Trail, IgnoresWhatIsNoPose) {
  trail.take({"/odom", ros::Odometry::kType}, "damaged");
  pose(std::nan(""), 0);
  EXPECT_EQ(trail.json().dump(), R"({"points":[]})");
}

}  // namespace
}  // namespace aisle
