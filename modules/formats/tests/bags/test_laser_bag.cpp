#include "aisle/formats/bags/laser_bag.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "aisle/formats/bags/bag_overview.hpp"
#include "aisle/formats/bags/bag_reader.hpp"
#include "bag_writers.hpp"
#include "pose_matchers.hpp"
#include "session_samples.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

ros::LaserScan five_beams(double stamp_s, const std::string& frame = "laser") {
  ros::LaserScan scan;
  scan.header = {ros::time_of(ros::stamp_ns(stamp_s)), frame};
  scan.angle_min = -1;
  scan.angle_max = 1;
  scan.angle_increment = 0.5F;
  scan.range_min = 0.1F;
  scan.range_max = 10;
  scan.ranges = {1, 2, 3, 4, 5};
  return scan;
}

ros::Odometry odometry_at(double stamp_s, double x) {
  ros::Odometry odometry;
  odometry.header = {ros::time_of(ros::stamp_ns(stamp_s)), "odom"};
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.position.x = x;
  return odometry;
}

ros::TransformStamped transform(const std::string& parent, const std::string& child,
                                const ros::Vector3& translation, const ros::Quaternion& rotation = {},
                                double stamp_s = 0) {
  return {{ros::time_of(ros::stamp_ns(stamp_s)), parent}, child, {translation, rotation}};
}

/// Ten scans and eleven odometry samples, 0.1 s apart, with the mount of the scanner.
struct Recorded {
  std::function<void(ros::LaserScan&, int)> change_scan = [](auto&, int) {};
  std::function<void(ros::Odometry&, int)> change_odometry = [](auto&, int) {};
  bool has_odometry = true;
  bool has_mount = true;
  ros::Quaternion mount = {};

  std::vector<WrittenMessage> messages(Written as = Written::kCdr) const {
    std::vector<WrittenMessage> all;
    if (has_mount) {
      all.push_back(
          written("/tf_static", 100, ros::TFMessage{{transform("plate", "laser", {0.1, 0, 0}, mount)}}, as));
      all.push_back(
          written("/tf_static", 100, ros::TFMessage{{transform("base_link", "plate", {0.2, 0, 0.5})}}, as));
    }
    for (int i = 0; i <= 10; ++i) {
      const double time_s = 100 + 0.1 * i;
      ros::Odometry odometry = odometry_at(time_s, 0.05 * i);
      change_odometry(odometry, i);
      if (has_odometry) all.push_back(written("/odom", time_s + 0.01, odometry, as));
      if (i == 10) break;
      ros::LaserScan scan = five_beams(time_s);
      change_scan(scan, i);
      all.push_back(written("/scan", time_s + 0.02, scan, as));
    }
    return all;
  }
};

Result<LaserRecording> read_messages(const std::vector<WrittenMessage>& messages,
                                     const RecordingOptions& options = {}) {
  const SessionPlace place;
  write_file(place / "bag.mcap", mcap_bytes(messages));
  return read_laser_bag(place / "bag.mcap", options);
}

std::string trouble(const Result<LaserRecording>& result) {
  return result ? "" : to_string(result.problems());
}

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

TEST(LaserBag, OfTwoPublishersOnOneTopicTheOneThatSeesIsTaken) {
  const auto recording = read_messages(Recorded{.change_scan = [](ros::LaserScan& scan, int i) {
                                         if (i % 3 == 0) return;
                                         scan.header = {{5, 0}, "simulated"};
                                         scan.ranges.assign(5, kInfinity);
                                       }}.messages());
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(recording->log.scans, SizeIs(4));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("comes from 2 publishers"));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("'laser' is taken"));
}

TEST(LaserBag, TopicsAreChosenByWhatTheySeeAndByName) {
  auto messages = Recorded{}.messages();
  const std::size_t own = messages.size();
  for (std::size_t i = 0; i < own; ++i) {
    if (messages[i].topic != "/scan") continue;
    ros::LaserScan blind = five_beams(ros::stamp_s(messages[i].log_stamp), "blind");
    blind.ranges.assign(5, kInfinity);
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

TEST(LaserBag, AnUnknownTopicIsAProblemThatListsWhatThereIs) {
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

TEST(LaserBag, OdometryMayComeFromTransformsAsMayMounts) {
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

TEST(LaserBag, TransformsAreTakenWhereTheOdometrysTopicHasAGap) {
  auto messages = Recorded{.change_odometry = [](ros::Odometry& odometry, int i) {
                    if (i > 5) odometry.header.stamp.sec += 20;
                  }}.messages();
  add_transforms(messages);
  const auto recording = read_messages(messages);
  ASSERT_TRUE(recording.ok()) << trouble(recording);
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("for /odom has nothing for 20.1 s"));
  EXPECT_THAT(recording->log.odometry, SizeIs(10));
}

TEST(LaserBag, APoseIsTakenForOdometryAndSaidButTheTruthIsNot) {
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

TEST(BagOverview, SaysWhatEveryTopicCouldServeFor) {
  const SessionPlace place;
  auto messages = Recorded{}.messages();
  messages.push_back(written("/chatter", 101, ros::String{"hi"}));
  write_file(place / "bag.mcap", mcap_bytes(messages, {"zstd", 4, false}));
  const auto overview = bag_overview(place / "bag.mcap");
  ASSERT_TRUE(overview.ok());
  ASSERT_THAT(overview->topics, SizeIs(4));
  EXPECT_EQ(overview->messages, 24);
  EXPECT_EQ(overview->topics[0].serves, "mounts");
  EXPECT_THAT(overview->topics[0].frames, ElementsAre("plate -> laser", "base_link -> plate"));
  EXPECT_EQ(overview->topics[1].serves, "odometry");
  EXPECT_THAT(overview->topics[1].frames, ElementsAre("odom -> base_link"));
  EXPECT_NEAR(overview->topics[1].rate_hz, 10, 1e-6);
  EXPECT_EQ(overview->topics[2].serves, "scan");
  EXPECT_EQ(overview->topics[2].topic.messages, 10);
  EXPECT_EQ(overview->topics[3].serves, "not read");
}

}  // namespace
}  // namespace aisle
