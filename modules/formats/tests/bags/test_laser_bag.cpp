#include "aisle/formats/bags/laser_bag.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "bag_samples.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

TEST(LaserBag, GivesScansOdometryAndTheMountAlongAChain) {
  const auto recording = read_messages(Recorded{}.messages());
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  const LaserLog& log = recording->log;
  EXPECT_EQ(to_string(recording->warnings), "");
  EXPECT_TRUE(recording->has_mounting);
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(Pose2{0.3, 0, 0}, 1e-9, 1e-9));
  EXPECT_DOUBLE_EQ(log.laser().range_max_m, 10);
  ASSERT_THAT(log.scans, SizeIs(10));
  ASSERT_THAT(log.odometry, SizeIs(11));
  EXPECT_THAT(log.scans[3].ranges_m, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_FALSE(log.scans[3].beams);
  EXPECT_EQ(log.scans[3].odometry_known, 4U);
  EXPECT_EQ(log.scans[3].line, 10);  // after two mounts, four samples and three scans
  EXPECT_NEAR(log.scans[3].time_s, 100.3, 1e-6);
  EXPECT_NEAR(log.odometry[4].T_odom_vehicle.x, 0.2, 1e-12);
}

TEST(LaserBag, IsTheSameFromEveryStore) {
  const SessionPlace place;
  const Recorded recorded;
  write_file(place / "a.mcap", mcap_bytes(recorded.messages()));
  write_db3(place / "b.db3", recorded.messages());
  write_file(place / "c.bag", ros1_bag_bytes(recorded.messages(Written::kRos1), {"lz4"}));
  const auto first = read_laser_bag(place / "a.mcap");
  for (const char* name : {"b.db3", "c.bag"}) {
    const auto other = read_laser_bag(place / name);
    ASSERT_TRUE(other.ok()) << trouble(other);
    ASSERT_EQ(other->log.scans.size(), first->log.scans.size());
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_EQ(other->log.scans[i].ranges_m, first->log.scans[i].ranges_m);
      EXPECT_EQ(other->log.scans[i].time_s, first->log.scans[i].time_s);
      EXPECT_EQ(other->log.scans[i].odometry_known, first->log.scans[i].odometry_known);
    }
    EXPECT_TRUE(other->has_mounting);
  }
}

TEST(LaserBag, ReadingsThatTellNothingAreZeroAndCounted) {
  const auto recording = read_messages(Recorded{.change_scan = [](ros::LaserScan& scan, int) {
                                         scan.ranges = {kNaN, -kInfinity, -1, 0.05F, 0, kInfinity, 12, 10, 2};
                                         scan.angle_increment = 0.25F;
                                       }}.messages());
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(recording->log.scans[0].ranges_m, ElementsAre(0, 0, 0, 0, 0, 10, 10, 10, 2));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("30 are nan, -inf or negative, 20 below range_min"));
}

TEST(LaserBag, ClockwiseReadingsAreReversedAndTheLastWasMeasuredFirst) {
  const auto recording = read_messages(Recorded{.change_scan = [](ros::LaserScan& scan, int) {
                                         std::swap(scan.angle_min, scan.angle_max);
                                         scan.angle_increment = -0.5F;
                                         scan.time_increment = 0.01F;
                                       }}.messages());
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  const LaserScan& scan = recording->log.scans[0];
  EXPECT_THAT(scan.ranges_m, ElementsAre(5, 4, 3, 2, 1));
  ASSERT_TRUE(scan.beams);
  EXPECT_NEAR(scan.beams->first_angle_rad, -1, 1e-6);
  EXPECT_NEAR(scan.beams->angle_step_rad, 0.5, 1e-6);
  EXPECT_NEAR(scan.beams->period_s, -0.01, 1e-6);
  EXPECT_NEAR(scan.time_s, 100.02, 1e-6);  // of the middle reading
}

TEST(LaserBag, AScannerUpsideDownIsSeenFromAbove) {
  const auto recording = read_messages(Recorded{
      .change_scan = [](ros::LaserScan& scan, int) { scan.angle_max = 0.5F, scan.ranges.pop_back(); },
      .mount = {1, 0, 0, 0}}.messages());
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(recording->log.scans[0].ranges_m, ElementsAre(4, 3, 2, 1));
  EXPECT_NEAR(recording->log.laser().first_angle_rad, -0.5, 1e-6);
  EXPECT_THAT(recording->log.laser().T_vehicle_laser, PoseNear(Pose2{0.3, 0, 0}, 1e-9, 1e-9));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("hangs upside down"));
}

TEST(LaserBag, TheNumberOfReadingsMayVary) {
  const auto recording = read_messages(Recorded{.change_scan = [](ros::LaserScan& scan, int i) {
                                         if (i % 2 == 0) return;
                                         scan.ranges.push_back(6);
                                         scan.angle_max = 1.5F;
                                       }}.messages());
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(recording->log.scans[1].ranges_m, SizeIs(6));
  EXPECT_EQ(to_string(recording->warnings), "");
}

ros::LaserScan with_angles(double first_deg, double last_deg, double step_deg, std::size_t readings) {
  ros::LaserScan scan = five_beams(100);
  scan.angle_min = static_cast<float>(first_deg * kDegree);
  scan.angle_max = static_cast<float>(last_deg * kDegree);
  scan.angle_increment = static_cast<float>(step_deg * kDegree);
  scan.ranges.assign(readings, 1);
  return scan;
}

double step_taken_deg(const ros::LaserScan& angles) {
  const auto recording = read_messages(Recorded{.change_scan = [&](ros::LaserScan& scan, int) {
                                         const ros::Header header = scan.header;
                                         scan = angles;
                                         scan.header = header;
                                       }}.messages());
  return recording ? recording->log.laser().angle_step_rad / kDegree : 0;
}

TEST(LaserBag, TheIncrementIsRightUnlessItWasRounded) {
  EXPECT_NEAR(step_taken_deg(with_angles(0, 359, 1, 360)), 1, 1e-5);
  EXPECT_NEAR(step_taken_deg(with_angles(0, 360, 1, 360)), 1, 1e-5);  // angle_max is one reading too far
  EXPECT_NEAR(step_taken_deg(with_angles(-180, 180, 0.401070456, 897)), 0.401070456, 1e-5);
  EXPECT_NEAR(step_taken_deg(with_angles(-135, 135, 0.0044 / kDegree, 1081)), 0.25, 1e-5);
  EXPECT_NEAR(step_taken_deg(with_angles(0, 359, 0.0175 / kDegree, 360)), 1, 1e-5);
  EXPECT_NEAR(step_taken_deg(with_angles(-90, 90, 0, 181)), 1, 1e-5);
}

TEST(LaserBag, AMountThatIsNotInTheBagIsNotInvented) {
  const auto recording = read_messages(Recorded{.has_mount = false}.messages());
  EXPECT_FALSE(recording->has_mounting);
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("does not tell where the scanner sits"));
  const auto given = read_messages(Recorded{}.messages(), {.T_vehicle_laser = Pose2{1, 2, 3}});
  EXPECT_TRUE(given->has_mounting);
  EXPECT_DOUBLE_EQ(given->log.laser().T_vehicle_laser.y, 2);
}

TEST(LaserBag, MessagesThatCannotBeReadAreLeftOut) {
  auto messages = Recorded{}.messages();
  for (WrittenMessage& message : messages) {
    if (message.topic == "/scan" && message.log_stamp < ros::stamp_ns(100.25)) message.bytes.resize(30);
  }
  const auto recording = read_messages(messages);
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(recording->log.scans, SizeIs(7));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("/scan: 3 of 10 messages are left out"));
}

}  // namespace
}  // namespace aisle
