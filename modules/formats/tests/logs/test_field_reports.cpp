/// What people bring: public bug reports of neighbouring projects, each in the smallest form that shows the
/// same situation. The name of a test is the report's.

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "aisle/core/angle.hpp"
#include "logs/carmen_lines.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A scan with its own angles, in radians as written there.
std::string robotlaser(const std::string& start, const std::string& field_of_view, const std::string& step,
                       const std::string& readings, std::size_t count, double stamp_s = 1) {
  return "ROBOTLASER1 0 " + start + " " + field_of_view + " " + step + " 10 0.01 0 " + std::to_string(count) +
         " " + readings + " 0 0 0 0 0 0 0 0.4 0 0.2 0.2 0 " + std::to_string(stamp_s) + " robot 0\n";
}

std::string equal_readings(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += i == 0 ? "2" : " 2";
  return text;
}

TEST(FieldReports_SlamToolbox198, TheParameterOfTheResolutionWins) {
  const LaserRecording with =
      parsed("PARAM laser_front_laser_resolution 1.0 nohost 0\n" + flaser_of(360, 0, 1));
  EXPECT_NEAR(with.log.laser().angle_step_rad, 1 * kDegree, 1e-12);
  EXPECT_NEAR(with.log.laser().first_angle_rad, -180 * kDegree, 1e-12);
  EXPECT_THAT(with.other_beams, IsEmpty());
}

TEST(FieldReports_CarmenPublisher1, WithoutItTheOtherFieldsOfViewAreGivenToo) {
  const LaserRecording without = parsed(flaser_of(360, 0, 1));
  EXPECT_NEAR(without.log.laser().angle_step_rad, 0.5 * kDegree, 1e-12);
  ASSERT_THAT(without.other_beams, SizeIs(Gt(0U)));
  EXPECT_NEAR(without.other_beams[0].first_angle_rad, -180 * kDegree, 1e-12);
  EXPECT_NEAR(without.other_beams[0].angle_step_rad, 1 * kDegree, 1e-12);
  EXPECT_THAT(parsed(flaser_of(181, 0, 1)).other_beams, IsEmpty());
}

TEST(FieldReports_RtabmapRos80, OdometryThatStartsAgainAtZeroIsSaidWithItsLine) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += flaser_of(3, i < 30 ? 0.1 * i : 0.1 * (i - 30), 0.2 * i);
  EXPECT_THAT(warnings_of(parsed(text)), HasSubstr("run.clf:31: the odometry jumps by 2.9 m"));
}

TEST(FieldReports_SlamToolbox602, EachScanIsReadByItsOwnNumberOfReadings) {
  std::string text;
  for (int i = 0; i < 10; ++i) text += flaser_of(i == 4 ? 179 : 180, 0, i);
  const LaserRecording carmen = parsed(text);
  ASSERT_THAT(carmen.log.scans, SizeIs(10));
  const LaserScan& odd = carmen.log.scans[4];
  EXPECT_THAT(odd.ranges_m, SizeIs(179));
  ASSERT_TRUE(odd.beams);
  EXPECT_NEAR(odd.beams->first_angle_rad, -90 * kDegree, 1e-12);
  EXPECT_NEAR(odd.beams->angle_step_rad, 1 * kDegree, 1e-12);
  EXPECT_FALSE(carmen.log.scans[3].beams);
  EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:5: 1 scans have other numbers of readings"));
}

TEST(FieldReports_LdlidarStlRos2_11, ATurningScannerSharesTheCircleAmongItsReadings) {
  const LaserRecording carmen = parsed(flaser_of(720, 0, 1) + flaser_of(720, 0, 2) + flaser_of(712, 0, 3));
  EXPECT_NEAR(carmen.log.scans[2].beams->angle_step_rad, 2 * kPi / 712, 1e-9);
  EXPECT_NEAR(carmen.log.scans[2].beams->first_angle_rad, -kPi, 1e-9);
}

TEST(FieldReports_SlamToolbox430, ScansWithTheirOwnAnglesKeepThem) {
  const LaserRecording carmen =
      parsed(robotlaser("-1.0", "2.0", "1.0", "1 2 3", 3, 1) + robotlaser("-0.5", "1.0", "1.0", "1 2", 2, 2) +
             robotlaser("-1.0", "2.0", "1.0", "1 2 3", 3, 3));
  EXPECT_NEAR(carmen.log.laser_of(carmen.log.scans[1]).first_angle_rad, -0.5, 1e-9);
  EXPECT_NEAR(carmen.log.laser_of(carmen.log.scans[2]).first_angle_rad, -1, 1e-9);
}

TEST(FieldReports_Navigation2d10, ReadingsThatAreNoDistancesTellNothing) {
  for (const char* reading : {"nan", "-nan", "-inf", "-1", "-0.5", "1e30"}) {
    const LaserRecording carmen = parsed(flaser(1) + flaser(2, std::string("1 ") + reading + " 3"));
    EXPECT_THAT(carmen.log.scans[1].ranges_m, ElementsAre(1, 0, 3)) << reading;
    EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:2: 1 readings are NaN, negative")) << reading;
  }
}

TEST(FieldReports_OpenslamGmapping3, PlusInfinityMeansThatNothingWasInRange) {
  const LaserRecording carmen = parsed(flaser(1, "1 inf 3"));
  EXPECT_GE(carmen.log.scans[0].ranges_m[1], carmen.log.laser().range_max_m);
}

TEST(FieldReports_SlamToolbox426, ARoundedIncrementGivesWayToTheFieldOfView) {
  const LaserRecording carmen =
      parsed(robotlaser("-2.356194", "4.712389", "0.0043", equal_readings(1081), 1081));
  EXPECT_NEAR(carmen.log.laser().angle_step_rad, 4.712389 / 1080, 1e-9);
  EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:1: the angular resolution does not fit"));
}

TEST(FieldReports_SlamToolbox426, OfAFullCircleTheFirstReadingFollowsTheLast) {
  const LaserRecording carmen = parsed(robotlaser("-3.141593", "6.28", "0.017", equal_readings(360), 360));
  EXPECT_NEAR(carmen.log.laser().angle_step_rad, 2 * kPi / 360, 1e-9);
  EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:1: the angular resolution does not fit"));
}

TEST(FieldReports_SlamToolbox63, AFieldOfViewOfOneStepMoreIsNoDisagreement) {
  const LaserRecording carmen =
      parsed(robotlaser("-1.570796", "3.141593", "0.017453", equal_readings(180), 180));
  EXPECT_NEAR(carmen.log.laser().angle_step_rad, 0.017453, 1e-9);
  EXPECT_THAT(carmen.warnings, IsEmpty());
}

TEST(FieldReports_SickScanXd159, BeamsThatRunClockwiseAreReadAsTheyAre) {
  const LaserRecording carmen = parsed(robotlaser("1.0", "-2.0", "-1.0", "1 2 3", 3));
  EXPECT_NEAR(carmen.log.laser().first_angle_rad, -1, 1e-9);
  EXPECT_NEAR(carmen.log.laser().angle_step_rad, 1, 1e-9);
  EXPECT_THAT(carmen.log.scans[0].ranges_m, ElementsAre(3, 2, 1));
  EXPECT_THAT(carmen.warnings, IsEmpty());
}

TEST(FieldReports_RtabmapRos1333, AClockSetBackByAnHourKeepsTheRecordedOrder) {
  std::string text;
  for (int i = 0; i < 20; ++i) text += flaser_of(3, 0.1 * i, i < 10 ? 5000 + 0.5 * i : 1400 + 0.5 * i);
  const LaserRecording carmen = parsed(text);
  ASSERT_THAT(carmen.log.scans, SizeIs(20));
  EXPECT_NEAR(carmen.log.scans[19].time_s - carmen.log.scans[0].time_s, 9.5, 1e-6);
  EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:11: stamps go back, jump or stand still at 1 places"));
}

TEST(FieldReports_Rosbag2_2133, WhatIsWholeOfALogThatIsCutOffIsUsed) {
  const std::string text = flaser(1) + flaser(2) + flaser(3);
  const LaserRecording carmen = parsed(text.substr(0, text.size() - 25));
  EXPECT_THAT(carmen.log.scans, SizeIs(2));
  EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:3: "));
}

TEST(FieldReports_Mcap385, NulBytesInTheMiddleCostTheirLineAlone) {
  const std::string nul(512, '\0');
  const LaserRecording within =
      parsed(flaser(1) + "FLASER 3 1 2" + nul + "2 0 1 2 0 7.5 host 1\n" + flaser(2));
  EXPECT_THAT(within.log.scans, SizeIs(2));
  EXPECT_THAT(warnings_of(within), HasSubstr("run.clf:2: "));
  const LaserRecording before = parsed(flaser(1) + "FLASER 3 1" + nul + flaser(2));
  EXPECT_THAT(before.log.scans, SizeIs(2));
}

TEST(FieldReports_SlamToolbox720, ScansThatAreMissingAreSaidWithPlaceLengthAndTime) {
  std::string text;
  for (int i = 0; i < 100; ++i) {
    if (i < 40 || i >= 90) text += flaser_of(3, 0.1 * i, 0.2 * i);
  }
  const LaserRecording carmen = parsed(text);
  EXPECT_EQ(warnings_of(carmen),
            "run.clf:41: scans are missing before this one: 5.1 m of odometry and 10.2 s without any");
}

TEST(FieldReports_AlsoSeen, MillimetresReadAsMetresAreRefusedWithTheAdvice) {
  EXPECT_THAT(carmen_problems(flaser(1, "1500 2000 3000")), HasSubstr("--units mm"));
  RecordingOptions millimetres;
  millimetres.unit = LengthUnit::kMillimetre;
  EXPECT_THAT(parsed(flaser(1, "1500 2000 3000"), millimetres).log.scans[0].ranges_m,
              ElementsAre(1.5F, 2, 3));
}

/// A round of 10 m diameter, driven once, with headings in this unit.
std::string round_trip(double units_per_radian) {
  std::string text;
  for (int i = 0; i <= 100; ++i) {
    const double angle = 2 * kPi * i / 100;
    const std::string pose = " " + std::to_string(5 * std::sin(angle)) + " " +
                             std::to_string(-5 * std::cos(angle)) + " " +
                             std::to_string(angle * units_per_radian);
    text += "FLASER 3 1 2 3" + pose + pose + " " + std::to_string(0.5 * i) + " host 0.1\n";
  }
  return text;
}

TEST(FieldReports_AlsoSeen, HeadingsInDegreesAreRefused) {
  EXPECT_THAT(carmen_problems(round_trip(180 / kPi)), HasSubstr("the headings are degrees"));
  EXPECT_EQ(carmen_problems(round_trip(1)), "");
}

}  // namespace
}  // namespace aisle
