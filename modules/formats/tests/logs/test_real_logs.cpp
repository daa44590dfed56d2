#include <gmock/gmock.h>

#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/formats/logs/carmen_log.hpp"
#include "aisle/formats/logs/rawlog.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"
#include "aisle/formats/logs/relations.hpp"
#include "pose_matchers.hpp"
#include "real_data.hpp"
#include "unpacked_file.hpp"

namespace aisle {
namespace {

using testing::Each;
using testing::Field;
using testing::IsEmpty;
using testing::SizeIs;

TEST(RealLogs, Fr079HasItsScansBeamsAndNoReturnValue) {
  const auto file = real_data() / "laser/fr079/fr079.clf.gz";
  AISLE_NEEDS(file);
  const auto carmen = read_laser_recording(file);
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  const LaserLog& log = carmen->log;
  EXPECT_THAT(carmen->warnings, IsEmpty());
  EXPECT_THAT(log.scans, SizeIs(4934));
  EXPECT_THAT(log.odometry, SizeIs(4934));
  EXPECT_THAT(log.scans, Each(Field(&LaserScan::ranges_m, SizeIs(360))));
  EXPECT_NEAR(log.laser().first_angle_rad, -kPi / 2, 1e-12);
  EXPECT_NEAR(log.laser().angle_step_rad, kPi / 360, 1e-12);
  EXPECT_GT(log.laser().range_max_m, 60);
  EXPECT_LT(log.laser().range_max_m, 81.91);
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(Pose2{}, 0, 0));
  EXPECT_FLOAT_EQ(log.scans[0].ranges_m[0], 1.67F);
  EXPECT_DOUBLE_EQ(log.scans[0].stamp_s, 1211.520329);
  EXPECT_DOUBLE_EQ(log.scans.back().time_s, log.scans.back().stamp_s);
}

TEST(RealLogs, AcesHasItsScansBeamsAndNoReturnValue) {
  const auto file = real_data() / "laser/aces/aces.clf.gz";
  AISLE_NEEDS(file);
  const auto carmen = read_laser_recording(file);
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  const LaserLog& log = carmen->log;
  EXPECT_THAT(carmen->warnings, IsEmpty());
  EXPECT_THAT(log.scans, SizeIs(7374));
  EXPECT_THAT(log.scans, Each(Field(&LaserScan::ranges_m, SizeIs(180))));
  EXPECT_NEAR(log.laser().angle_step_rad, kDegree, 1e-12);
  EXPECT_NEAR(log.laser().range_max_m, 50, 2);
}

TEST(RealLogs, TheRawlogOfAcesHasTheScansOfTheCarmenLog) {
  const auto clf = real_data() / "laser/aces/aces.clf.gz";
  const auto rawlog = real_data() / "recordings/mrpt-rawlog/aces.rawlog";
  AISLE_NEEDS(clf);
  AISLE_NEEDS(rawlog);
  const auto carmen = read_laser_recording(clf);
  const auto packed = read_unpacked_file(rawlog);
  ASSERT_TRUE(packed.ok());
  const auto mrpt = parse_rawlog(packed->bytes, rawlog.string());
  ASSERT_TRUE(carmen.ok() && mrpt.ok());
  EXPECT_THAT(to_string(mrpt->warnings), testing::HasSubstr("aperture of 90 deg"));
  EXPECT_EQ(mrpt->log.laser().first_angle_rad, carmen->log.laser().first_angle_rad);
  EXPECT_EQ(mrpt->log.laser().range_max_m, carmen->log.laser().range_max_m);
  ASSERT_EQ(mrpt->log.scans.size(), carmen->log.scans.size());
  std::size_t different = 0;  // two readings of one scan were converted otherwise
  for (std::size_t i = 0; i < carmen->log.scans.size(); ++i) {
    ASSERT_EQ(mrpt->log.scans[i].ranges_m.size(), carmen->log.scans[i].ranges_m.size());
    for (std::size_t beam = 0; beam < carmen->log.scans[i].ranges_m.size(); ++beam) {
      different += mrpt->log.scans[i].ranges_m[beam] != carmen->log.scans[i].ranges_m[beam];
    }
    EXPECT_THAT(mrpt->log.odometry[i].T_odom_vehicle,
                PoseNear(carmen->log.odometry[i].T_odom_vehicle, 1e-6, 1e-6));
  }
  EXPECT_LE(different, 2U);
}

TEST(RealLogs, BothKindsOfRawlogAndOldClassesAreRead) {
  const auto folder = real_data() / "recordings/mrpt-rawlog/mrpt-demo";
  AISLE_NEEDS(folder);
  for (const auto& [name, scans] : {std::pair("2006-01ENE-21-SENA_Telecom_Faculty_one_loop_only.rawlog", 225),
                                    {"localization_demo.rawlog", 37}}) {
    const auto packed = read_unpacked_file(folder / name);
    ASSERT_TRUE(packed.ok());
    const auto recording = parse_rawlog(packed->bytes, name);
    ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
    EXPECT_THAT(recording->warnings, IsEmpty());
    EXPECT_THAT(recording->log.scans, SizeIs(scans));
    EXPECT_THAT(recording->log.odometry, SizeIs(scans));
    EXPECT_THAT(recording->log.laser().T_vehicle_laser, PoseNear(Pose2{0.78, 0, 0}, 1e-3, 1e-6));
    EXPECT_NEAR(recording->log.laser().angle_step_rad, 0.5 * kDegree, 1e-6);
  }
}

TEST(RealLogs, ScansThatChangeTheirNumberAreReadFromBzip2) {
  const auto file = real_data() / "recordings/mrpt-rawlog/fr-clinic_robotlaser.clf.bz2";
  AISLE_NEEDS(file);
  const auto carmen = read_laser_recording(file);
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  EXPECT_THAT(carmen->log.scans, SizeIs(6917));
  EXPECT_NEAR(carmen->log.laser().T_vehicle_laser.x, 0.22, 1e-6);
}

TEST(RealLogs, OfStampsThatAreAllAlikeTheTimesFollowTheMotion) {
  const auto file = real_data() / "recordings/corrected-logs/csail-corrected.log.gz";
  AISLE_NEEDS(file);
  const auto carmen = read_laser_recording(file);
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  EXPECT_NEAR(carmen->log.scan_period_s(), 2, 0.5);
  EXPECT_THAT(to_string(carmen->warnings), testing::HasSubstr("guessed from how far the vehicle moved"));
  EXPECT_THAT(to_string(carmen->warnings), testing::HasSubstr("a mapping program has corrected them"));
}

TEST(RealLogs, Fr079RelationsByStampAreThoseByNumber) {
  const auto folder = real_data() / "laser/fr079";
  AISLE_NEEDS(folder);
  const auto carmen = read_laser_recording(folder / "fr079.clf.gz");
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  const auto by_stamp = read_relations(folder / "fr079.relations.gz", carmen->log);
  ASSERT_TRUE(by_stamp.ok()) << to_string(by_stamp.problems());
  const auto by_number = read_relations(folder / "fr079.relations-by-index.gz", carmen->log);
  ASSERT_TRUE(by_number.ok()) << to_string(by_number.problems());
  ASSERT_THAT(*by_stamp, SizeIs(1685));
  ASSERT_THAT(*by_number, SizeIs(1685));
  for (std::size_t i = 0; i < by_stamp->size(); ++i) {
    EXPECT_EQ((*by_stamp)[i].scan_1, (*by_number)[i].scan_1);
    EXPECT_EQ((*by_stamp)[i].scan_2, (*by_number)[i].scan_2);
    EXPECT_THAT((*by_stamp)[i].T_1_2, PoseNear((*by_number)[i].T_1_2, 1e-6, 1e-6));
  }
}

}  // namespace
}  // namespace aisle
