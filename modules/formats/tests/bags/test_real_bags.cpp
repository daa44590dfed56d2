#include <gmock/gmock.h>

#include <cmath>

#include "aisle/formats/bags/bag_reader.hpp"
#include "aisle/formats/bags/laser_bag.hpp"
#include "pose_matchers.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

double path_length_m(const LaserLog& log) {
  double length_m = 0;
  for (std::size_t i = 1; i < log.odometry.size(); ++i)
    length_m +=
        (log.odometry[i].T_odom_vehicle.position() - log.odometry[i - 1].T_odom_vehicle.position()).norm();
  return length_m;
}

TEST(RealBags, ATurtleBotOfRos2IsTheSameInSqliteAndMcap) {
  const auto folder = real_data() / "recordings/turtlebot4-office-db3";
  AISLE_NEEDS(folder);
  const auto sqlite = read_laser_bag(folder);
  const auto mcap = read_laser_bag(folder / "CONVERTED_take_2.mcap");
  ASSERT_TRUE(sqlite.ok() && mcap.ok());
  EXPECT_THAT(sqlite->log.scans, SizeIs(357));
  EXPECT_THAT(sqlite->log.odometry, SizeIs(920));
  EXPECT_NEAR(path_length_m(sqlite->log), 8.4, 0.1);
  EXPECT_TRUE(sqlite->has_mounting);
  EXPECT_NEAR(sqlite->log.laser().T_vehicle_laser.theta, 90 * kDegree, 1e-3);  // only /tf_static says so
  EXPECT_NEAR(sqlite->log.laser().first_angle_rad, -179 * kDegree, 1e-3);
  for (std::size_t i = 0; i < 357; ++i) {
    EXPECT_EQ(sqlite->log.scans[i].ranges_m, mcap->log.scans[i].ranges_m);
    EXPECT_EQ(sqlite->log.scans[i].time_s, mcap->log.scans[i].time_s);
  }
}

TEST(RealBags, ANeatoOfRos1HasItsOwnScansAndItsMountFromTheTransforms) {
  const auto file = real_data() / "recordings/neato-bag/obstacle_avoid_demo_2018-09-18-20-30-36.bag";
  AISLE_NEEDS(file);
  const auto recording = read_laser_bag(file);
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_THAT(recording->log.scans, SizeIs(362));
  EXPECT_NEAR(path_length_m(recording->log), 17.6, 0.1);
  EXPECT_NEAR(recording->log.laser().T_vehicle_laser.x, -0.102, 1e-3);
  EXPECT_THAT(to_string(recording->warnings),
              HasSubstr("/scan: is taken of the topics with scans: /stable_scan"));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("67.3 % of the readings tell nothing"));
}

TEST(RealBags, ACorridorsGapIsSaidAndItsOdometryComesFromWhereItIsWhole) {
  const auto file = real_data() / "recordings/corridor-kidnap-bag/2019_jan17_expt04_bagfile.bag";
  AISLE_NEEDS(file);
  const auto recording = read_laser_bag(file);
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_THAT(recording->log.scans, SizeIs(962));
  EXPECT_NEAR(path_length_m(recording->log), 19.8, 0.1);
  EXPECT_FALSE(recording->has_mounting);
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("/odom has nothing for 14.6 s"));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr(":786: /scan: nothing for 5.5 s after this message"));
}

TEST(RealBags, ARecordingOfAReplayKeepsItsOldStamps) {
  const auto file = real_data() / "recordings/corridor-kidnap-bag/2018_dec13_target_before.bag";
  AISLE_NEEDS(file);
  const auto recording = read_laser_bag(file);
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_NEAR(path_length_m(recording->log), 13.1, 0.1);
  EXPECT_THAT(to_string(recording->warnings), Not(HasSubstr("clock")));
}

TEST(RealBags, MotionCaptureIsTakenForOdometryInBothFormats) {
  const auto folder = real_data() / "recordings/jackal-mocap";
  AISLE_NEEDS(folder);
  const auto ros1 = read_laser_bag(folder / "test_2026-02-17-15-54-31.bag");
  const auto ros2 = read_laser_bag(folder / "test_2026-02-17-15-54-31");
  ASSERT_TRUE(ros1.ok() && ros2.ok());
  for (const auto* recording : {&*ros1, &*ros2}) {
    EXPECT_THAT(recording->log.scans, SizeIs(414));
    EXPECT_THAT(recording->log.odometry, SizeIs(4734));
    EXPECT_NEAR(recording->log.laser().angle_step_rad, 0.007, 1e-6);
    EXPECT_THAT(to_string(recording->warnings), HasSubstr("it is a pose that something else measured"));
  }
  EXPECT_EQ(ros1->log.scans[100].ranges_m, ros2->log.scans[100].ranges_m);
}

TEST(RealBags, OfTwoPublishersTheRealScannerIsTaken) {
  const auto folder = real_data() / "recordings/two-publishers-db3/mydata3";
  AISLE_NEEDS(folder);
  const auto recording = read_laser_bag(folder);
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_THAT(recording->log.scans, SizeIs(238));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("'base_laser' is taken"));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("has no odometry"));
}

TEST(RealBags, AScannerWhoseLastAngleIsOneTooFarHasItsIncrement) {
  const auto file = real_data() / "recordings/xv11-car-bag/pegatron5F.bag";
  AISLE_NEEDS(file);
  const auto recording = read_laser_bag(file);
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_THAT(recording->log.scans, SizeIs(449));
  EXPECT_NEAR(recording->log.laser().angle_step_rad, 1 * kDegree, 1e-6);
}

TEST(RealBags, ASimulatedHouseStartsLongAfterZero) {
  const auto file = real_data() / "recordings/SIMULATED-tb3-house/home_deneme_2020-05-30-13-10-27.bag";
  AISLE_NEEDS(file);
  const auto recording = read_laser_bag(file);
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_NEAR(recording->log.scans[0].time_s, 206.98, 0.01);
  EXPECT_NEAR(recording->log.laser().angle_step_rad, 360 * kDegree / 359, 1e-5);
  EXPECT_NEAR(path_length_m(recording->log), 9.6, 0.1);
}

}  // namespace
}  // namespace aisle
