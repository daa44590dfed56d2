#include <gmock/gmock.h>

#include <limits>

#include "aisle/formats/bags/laser_bag.hpp"
#include "bag_samples.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr float kNothingInRange = std::numeric_limits<float>::infinity();

TEST(LaserBagChoice, OfTwoPublishersOnOneTopicTheOneThatSeesIsTaken) {
  const auto recording = read_messages(Recorded{.change_scan = [](ros::LaserScan& scan, int i) {
                                         if (i % 3 == 0) return;
                                         scan.header = {{5, 0}, "simulated"};
                                         scan.ranges.assign(5, kNothingInRange);
                                       }}.messages());
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(recording->log.scans, SizeIs(4));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("comes from 2 publishers"));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("'laser' is taken"));
}

TEST(LaserBagChoice, TopicsAreChosenByWhatTheySeeAndByName) {
  auto messages = Recorded{}.messages();
  const std::size_t own = messages.size();
  for (std::size_t i = 0; i < own; ++i) {
    if (messages[i].topic != "/scan") continue;
    ros::LaserScan blind = five_beams(ros::stamp_s(messages[i].log_stamp), "blind");
    blind.ranges.assign(5, kNothingInRange);
    for (int k = 0; k < 2; ++k)
      messages.push_back(written("/blind_scan", ros::stamp_s(messages[i].log_stamp), blind));
  }
  const auto chosen = read_messages(messages);
  ASSERT_TRUE(chosen.ok()) << trouble(chosen);
  EXPECT_THAT(to_string(chosen->warnings),
              HasSubstr("/scan: is taken of the topics with scans: /scan (10), /blind_scan (20)"));
  EXPECT_THAT(chosen->log.scans, SizeIs(10));
  const auto both = read_messages(messages, {.scan_topic = "scan, blind_scan"});
  ASSERT_TRUE(both.ok()) << trouble(both);
  EXPECT_THAT(both->log.lasers, SizeIs(2));
  EXPECT_THAT(both->log.scans, SizeIs(30));
  EXPECT_EQ(both->log.scans.back().laser, 1U);
}

TEST(LaserBagChoice, AnUnknownTopicIsAProblemThatListsWhatThereIs) {
  const auto messages = Recorded{}.messages();
  EXPECT_THAT(
      trouble(read_messages(messages, {.scan_topic = "/front"})),
      HasSubstr("/front: is no such topic of the bag; it has /tf_static (tf2_msgs/msg/TFMessage, 2), /odom"));
  EXPECT_THAT(trouble(read_messages(messages, {.odometry = "/wheels"})),
              HasSubstr("/wheels: is no such topic"));
  EXPECT_THAT(trouble(read_messages(messages, {.scan_topic = "/odom"})),
              HasSubstr("/odom: has no scans but nav_msgs/msg/Odometry"));
  EXPECT_THAT(trouble(read_messages({written("/odom", 1, ros::Odometry{})})), HasSubstr("has no scans"));
}

/// /tf with odom -> base_link, map -> odom that jumps, and the mount, which is sent over and over.
void add_transforms(std::vector<WrittenMessage>& messages) {
  const auto recorded = messages;
  messages.clear();
  int i = 0;
  for (const WrittenMessage& message : recorded) {
    messages.push_back(message);
    if (message.topic != "/scan") continue;
    const double time_s = 100 + 0.1 * i++;
    messages.push_back(written("/tf", time_s + 0.03,
                               ros::TFMessage{{transform("/odom", "/base_link", {0.05 * i, 0, 0}, {}, time_s),
                                               transform("map", "odom", {5.0 * i, 0, 0}, {}, time_s),
                                               transform("base_link", "laser", {0.4, 0, 0}, {}, time_s)}}));
  }
}

TEST(LaserBagChoice, OdometryMayComeFromTransformsAsMayMounts) {
  auto messages = Recorded{.has_odometry = false, .has_mount = false}.messages();
  add_transforms(messages);
  const auto recording = read_messages(messages);
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(recording->log.odometry, SizeIs(10));
  EXPECT_NEAR(recording->log.odometry[9].T_odom_vehicle.x, 0.5, 1e-9);
  EXPECT_THAT(recording->log.laser().T_vehicle_laser, PoseNear(Pose2{0.4, 0, 0}, 1e-9, 1e-9));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("/tf: gives the odometry (odom -> base_link)"));
  EXPECT_THAT(read_messages(messages, {.odometry = "none"})->log.odometry, SizeIs(0));
}

TEST(LaserBagChoice, TransformsAreTakenWhereTheOdometrysTopicHasAGap) {
  auto messages = Recorded{.change_odometry = [](ros::Odometry& odometry, int i) {
                    if (i > 5) odometry.header.stamp.sec += 20;
                  }}.messages();
  add_transforms(messages);
  const auto recording = read_messages(messages);
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("for /odom has nothing for 20.1 s"));
  EXPECT_THAT(recording->log.odometry, SizeIs(10));
}

TEST(LaserBagChoice, APoseIsTakenForOdometryAndSaidButTheTruthIsNot) {
  auto messages = Recorded{.has_odometry = false}.messages();
  EXPECT_THAT(to_string(read_messages(messages)->warnings), HasSubstr("has no odometry"));
  for (int i = 0; i < 10; ++i) {
    ros::PoseStamped pose;
    pose.header = {ros::time_of(ros::stamp_ns(100 + 0.1 * i)), "world"};
    messages.push_back(written("/truth/pose", 100 + 0.1 * i, pose));
  }
  EXPECT_THAT(read_messages(messages)->log.odometry, SizeIs(0));
  for (auto& message : messages) {
    if (message.topic == "/truth/pose") message.topic = "/robot/pose";
  }
  const auto recording = read_messages(messages);
  EXPECT_THAT(recording->log.odometry, SizeIs(10));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("/robot/pose: is taken for the odometry"));
  EXPECT_EQ(recording->log.scans[5].odometry_known, 6U);  // all poses follow all scans in the file
}

}  // namespace
}  // namespace aisle
