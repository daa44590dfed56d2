#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>

#include "aisle/core/angle.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"
#include "logs/carmen_lines.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(CarmenLog, AFlaserLineIsAScanWithItsOwnOdometry) {
  const LaserLog log = parsed("# a comment\n\n" + flaser(10.25) + flaser(10.5, "1 1 1")).log;
  ASSERT_THAT(log.scans, SizeIs(2));
  EXPECT_THAT(log.scans[0].ranges_m, ElementsAre(1.5F, 2, 3));
  EXPECT_EQ(log.scans[0].stamp_s, 10.25);
  EXPECT_EQ(log.scans[1].time_s, 10.5);
  EXPECT_EQ(log.scans[1].odometry_known, 2U);
  ASSERT_THAT(log.odometry, SizeIs(2));
  EXPECT_EQ(log.odometry[1].time_s, 10.5);
  EXPECT_THAT(log.odometry[1].T_odom_vehicle, PoseNear(Pose2{1, 2, 0.5}, 0, 0));
}

TEST(CarmenLog, FlaserBeamsRunFromTheRightToTheLeft) {
  for (const std::size_t beams : {180, 181, 360, 361, 3, 90}) {
    const LaserScanner laser = flaser_scanner(beams);
    EXPECT_NEAR(laser.beam_angle(0), -kPi / 2, 1e-12) << beams;
    EXPECT_NEAR(laser.beam_angle(beams - 1), kPi / 2, 1.01 * kDegree) << beams;
  }
  EXPECT_NEAR(flaser_scanner(180).beam_angle(90), 0, 1e-12);
  EXPECT_NEAR(flaser_scanner(541).beam_angle(0), -135 * kDegree, 1e-12);
}

TEST(CarmenLog, TheResolutionParameterDecidesWhereTheCountIsAmbiguous) {
  const LaserLog log = parsed(flaser(1) + "PARAM laser_front_laser_resolution 10 nohost 0\n").log;
  EXPECT_NEAR(log.laser().angle_step_rad, 10 * kDegree, 1e-12);
  EXPECT_NEAR(log.laser().beam_angle(1), 0, 1e-12);
}

TEST(CarmenLog, WithRawScansTheOdometryIsThatOfTheOdomLines) {
  const LaserLog log = parsed(odom(0, 1) + rawlaser(1.05) + odom(0.5, 2) + odom(1, 3) + rawlaser(3.05)).log;
  EXPECT_NEAR(log.laser().first_angle_rad, -1, 1e-12);
  EXPECT_NEAR(log.laser().angle_step_rad, 1, 1e-12);
  ASSERT_THAT(log.scans, SizeIs(2));
  EXPECT_EQ(log.scans[0].odometry_known, 1U);
  EXPECT_EQ(log.scans[1].odometry_known, 3U);
  ASSERT_THAT(log.odometry, SizeIs(3));
  EXPECT_EQ(log.odometry[1].T_odom_vehicle.x, 0.5);
  EXPECT_EQ(log.odometry[1].time_s, 2);
}

TEST(CarmenLog, ARobotLaserLineHasItsOwnPosesAndMounting) {
  const LaserLog log =
      parsed(
          "ROBOTLASER1 0 -1.0 2.0 1.0 10.0 0.01 0 3 1 2 3 2 7 8 1.5 2 0 1 2 0 0.1 0 0.2 0.3 1e6 5 host 5\n")
          .log;
  EXPECT_THAT(log.odometry.at(0).T_odom_vehicle, PoseNear(Pose2{1, 2, 0}, 0, 0));
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(Pose2{0.5, 0, 0}, 1e-12, 1e-12));
  EXPECT_LT(log.laser().range_max_m, 10);
  EXPECT_GT(log.laser().range_max_m, 9);
}

TEST(CarmenLog, OnlyTheFirstKindOfScanCounts) {
  EXPECT_THAT(parsed(flaser(1) + rawlaser(1) + flaser(2)).log.scans, SizeIs(2));
  EXPECT_THAT(parsed(odom(0, 1) + rawlaser(1) + flaser(1) + rawlaser(2) + flaser(2)).log.odometry, SizeIs(1));
  EXPECT_THAT(parsed(odom(0, 1) + flaser(1) + odom(0, 1.5)).log.odometry, SizeIs(1));
}

TEST(CarmenLog, TheMountingIsTheUsersElseTheParametersElseThatOfThePoses) {
  const std::string scan = "FLASER 3 1 2 3 1.1 0 0 1 0 0 1 host 1\n";
  const std::string params =
      "PARAM robot_frontlaser_offset 0.2 host 1\nPARAM robot_frontlaser_side_offset 0.3 host 1\n";
  EXPECT_THAT(parsed(scan).log.laser().T_vehicle_laser, PoseNear(Pose2{0.1, 0, 0}, 1e-12, 0));
  EXPECT_THAT(parsed(scan + params).log.laser().T_vehicle_laser, PoseNear(Pose2{0.2, 0.3, 0}, 1e-12, 0));
  RecordingOptions options;
  options.T_vehicle_laser = Pose2{0.5, 0, 1};
  EXPECT_THAT(parsed(scan + params, options).log.laser().T_vehicle_laser, PoseNear(Pose2{0.5, 0, 1}, 0, 0));
}

TEST(CarmenLog, CorrectedLaserPosesTellNothingAboutTheMounting) {
  const std::string text = "FLASER 3 1 2 3 1.1 0 0 1 0 0 1 host 1\nFLASER 3 1 2 3 2.3 0 0 2 0 0 2 host 1\n";
  EXPECT_THAT(parsed(text).log.laser().T_vehicle_laser, PoseNear(Pose2{}, 0, 0));
}

TEST(CarmenLog, InCentimetresEveryLengthIsAHundredthOfAMetre) {
  RecordingOptions options;
  options.unit = LengthUnit::kCentimetre;
  const LaserLog log =
      parsed("PARAM robot_frontlaser_offset 25\nFLASER 3 150 200 300 100 200 0.5 100 200 0.5 1 host 1\n",
             options)
          .log;
  EXPECT_THAT(log.scans[0].ranges_m, ElementsAre(1.5F, 2, 3));
  EXPECT_THAT(log.odometry[0].T_odom_vehicle, PoseNear(Pose2{1, 2, 0.5}, 1e-12, 0));
  EXPECT_NEAR(log.laser().T_vehicle_laser.x, 0.25, 1e-12);
}

TEST(CarmenLog, WrongUnitsAreWarnedOf) {
  RecordingOptions centimetres;
  centimetres.unit = LengthUnit::kCentimetre;
  EXPECT_THAT(warnings_of(parsed(flaser(1, "150 200 290"))), HasSubstr("--units cm"));
  EXPECT_THAT(warnings_of(parsed("PARAM robot_front_laser_max 50\n" + flaser(1, "150 200 290"))),
              HasSubstr("--units cm"));
  EXPECT_THAT(warnings_of(parsed(flaser(1), centimetres)), HasSubstr("--units cm"));
  EXPECT_THAT(parsed(flaser(1, "150 200 300"), centimetres).warnings, IsEmpty());
}

TEST(CarmenLog, ARepeatedLargestReadingMeansNothingSeen) {
  const double range_max_m = parsed(flaser(1, "2 50 50") + flaser(2, "50 3 4")).log.laser().range_max_m;
  EXPECT_LT(range_max_m, 50);
  EXPECT_GT(range_max_m, 45);
  EXPECT_GT(parsed(flaser(1, "2 5 6")).log.laser().range_max_m, 6);
  EXPECT_NEAR(parsed(flaser(1, "2 5 6") + "PARAM robot_front_laser_max 8\n").log.laser().range_max_m, 8, 0.5);
}

TEST(CarmenLog, InfiniteReadingsMeanThatNothingWasInRange) {
  const LaserRecording carmen = parsed("PARAM robot_front_laser_max 8\n" + flaser(1, "inf 2 3"));
  EXPECT_GE(carmen.log.scans[0].ranges_m[0], carmen.log.laser().range_max_m);
  EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:2: 1 readings are infinite"));
  const LaserRecording without_maximum = parsed(flaser(1, "inf 2 3"));
  EXPECT_GE(without_maximum.log.scans[0].ranges_m[0], without_maximum.log.laser().range_max_m);
  EXPECT_GT(without_maximum.log.laser().range_max_m, 3);
}

TEST(CarmenLog, StampsThatGoBackAreMendedAndTheScansStayInFileOrder) {
  std::string text;
  for (const double stamp_s : {100.0, 100.5, 101.0, 3.0, 3.5, 9000.0, 9000.5}) text += flaser(stamp_s);
  const LaserRecording carmen = parsed(text);
  std::vector<double> stamps, times;
  for (const LaserScan& scan : carmen.log.scans) {
    stamps.push_back(scan.stamp_s);
    times.push_back(scan.time_s);
  }
  EXPECT_THAT(stamps, ElementsAre(100, 100.5, 101, 3, 3.5, 9000, 9000.5));
  EXPECT_THAT(times, ElementsAre(100, 100.5, 101, 101.5, 102, 102.5, 103));
  EXPECT_EQ(warnings_of(carmen),
            "run.clf:4: stamps go back, jump or stand still at 2 places, first here; "
            "scans are taken in file order");
}

TEST(CarmenLog, AStoppedClockIsWarnedOfWithTheStepThatIsTaken) {
  EXPECT_EQ(warnings_of(parsed(flaser(7) + flaser(7) + flaser(7) + flaser(7))),
            "run.clf:2: stamps go back, jump or stand still at 3 places, first here; "
            "scans are taken in file order, with times guessed from how far the vehicle moved");
}

TEST(CarmenLog, OdometryThatJumpsIsWarnedOfOnceWithItsPlace) {
  const auto at = [](double x_m, double stamp_s) { return odom(x_m, stamp_s) + rawlaser(stamp_s); };
  EXPECT_EQ(warnings_of(parsed(at(0, 1) + at(1, 2) + at(2, 3) + at(23, 4) + at(24, 5) + at(0, 6))),
            "run.clf:7: the odometry jumps by 21.0 m, 0 deg from the pose before; 2 such jumps");
  EXPECT_THAT(parsed(at(0, 1) + at(3, 2) + at(6, 3)).warnings, IsEmpty());
}

TEST(CarmenLog, OtherMessagesAreSkippedAndUnknownOnesCounted) {
  EXPECT_THAT(parsed("SYNC tag 1 host 1\nNMEA-GGA 1\nRLASER 1 5\nNEFF 20\n" + flaser(1)).warnings, IsEmpty());
  EXPECT_EQ(warnings_of(parsed("HELLO\n" + flaser(1) + "WORLD 3\n")),
            "run.clf:1: 'HELLO' is not a CARMEN message; 2 such lines were skipped");
}

TEST(CarmenLog, LineEndsOfOtherSystemsAndNoneAtAllAreFine) {
  std::string text = flaser(1) + flaser(2);
  text.pop_back();
  EXPECT_THAT(parsed(text).log.scans, SizeIs(2));
  EXPECT_THAT(parsed("FLASER 3 1 2 3 1 2 0 1 2 0\t1 host 1\r\n").log.scans, SizeIs(1));
}

struct DamagedLine {
  std::string name, line, damage;

  friend void PrintTo(const DamagedLine& line, std::ostream* out) { *out << line.damage; }
};

class DamagedCarmenLog : public testing::TestWithParam<DamagedLine> {};

TEST_P(DamagedCarmenLog, IsReadWithoutTheLineAndAWarningWithItsPlace) {
  const LaserRecording carmen = parsed(flaser(1) + flaser(2) + GetParam().line);
  EXPECT_THAT(carmen.log.scans, SizeIs(2));
  EXPECT_THAT(warnings_of(carmen), HasSubstr("run.clf:3: "));
  EXPECT_THAT(warnings_of(carmen), HasSubstr(GetParam().damage));
}

INSTANTIATE_TEST_SUITE_P(
    CarmenLog, DamagedCarmenLog,
    testing::Values(
        DamagedLine{"CutOffInTheReadings", "FLASER 3 1 2", "the line ends after 4 fields"},
        DamagedLine{"CutOffInThePoses", "FLASER 3 1 2 3 1 2 0 1", "the line ends after 9 fields"},
        DamagedLine{"CutOffInTheStamps", "FLASER 3 1 2 3 1 2 0 1 2 0 7.5 ho", "the line ends before"},
        DamagedLine{"CutOffInTheName", "FLAS", "the file is cut off here"},
        DamagedLine{"OdometryCutOff", "ODOM 1 2", "the line ends after 3 fields, before its robot pose"},
        DamagedLine{"MoreFieldsThanAnnounced", "FLASER 3 1 2 3 4 5 6 1 2 0 1 2 0 7.5 host 1\n",
                    "more fields"},
        DamagedLine{"WordForAReading", flaser(1, "1 x 3"), "'x' is not a number"},
        DamagedLine{"InfinitePose", "FLASER 3 1 2 3 inf 2 0 1 2 0 7 host 1\n",
                    "laser pose: 'inf' is absurdly large"},
        DamagedLine{"NanStamp", "FLASER 3 1 2 3 1 2 0 1 2 0 nan host 1\n", "ipc timestamp: 'nan'"},
        DamagedLine{"HugeCount", "FLASER 1e9 1 2 3 1 2 0 1 2 0 7 host 1\n",
                    "not a whole number from 2 to 10000"},
        DamagedLine{"BrokenCount", "FLASER 2.5 1 2 3 1 2 0 1 2 0 7 host 1\n", "not a whole number"},
        DamagedLine{"ZeroResolution", "PARAM laser_front_laser_resolution 0\n", "not positive"},
        DamagedLine{"ParameterWithoutValue", "PARAM robot_frontlaser_offset\n", "before its offset"}),
    [](const auto& line) { return line.param.name; });

TEST(CarmenLog, AParameterThatIsLeftOutSaysNothing) {
  const LaserRecording carmen = parsed("PARAM laser_front_laser_resolution 0\n" + flaser(1));
  EXPECT_NEAR(carmen.log.laser().angle_step_rad, 90 * kDegree, 1e-12);
}

TEST(CarmenLog, WithoutAScanIsRefused) {
  EXPECT_EQ(carmen_problems(""), "run.clf: is empty");
  EXPECT_THAT(carmen_problems("# nothing\n" + odom(1, 2)), HasSubstr("run.clf: has no scans"));
}

TEST(CarmenLog, IsRefusedWhereMostLinesCannotBeRead) {
  EXPECT_THAT(carmen_problems(flaser(1) + "FLASER 3 1\nFLASER 3 1\n"), HasSubstr("run.clf:2: the line ends"));
  EXPECT_EQ(carmen_problems(flaser(1) + "FLASER 3 1\n"), "");
}

TEST(CarmenLog, RawScansWithoutOdometryAreScansAlone) {
  const LaserRecording carmen = parsed(rawlaser(1) + rawlaser(2));
  EXPECT_THAT(carmen.log.odometry, IsEmpty());
  EXPECT_THAT(warnings_of(carmen), HasSubstr("has no odometry"));
}

TEST(CarmenLog, AFileFullOfProblemsShowsTwentyAndCountsTheRest) {
  std::string text;
  for (int i = 0; i < 25; ++i) text += "FLASER\n";
  const auto carmen = parse_carmen_log(text, "run.clf");
  ASSERT_THAT(carmen.problems(), SizeIs(21));
  EXPECT_EQ(to_string(carmen.problems().back()), "run.clf: ... and 5 more");
}

TEST(CarmenLog, AMissingFileIsAProblem) {
  EXPECT_THAT(to_string(read_laser_recording("/nowhere/run.clf").problems()),
              HasSubstr("/nowhere/run.clf: no such file"));
}

}  // namespace
}  // namespace aisle
