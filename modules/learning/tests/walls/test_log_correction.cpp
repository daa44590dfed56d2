#include "aisle/learning/walls/log_correction.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "pose_matchers.hpp"
#include "walls/recorded_drive.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

LogFindings findings_in(LaserLog& log, const OpenOfLog& open = {}) {
  SilentProgress progress;
  const Result<LogFindings> findings = correct_log(log, open, progress);
  EXPECT_TRUE(findings.ok()) << to_string(findings.problems());
  return findings.ok() ? findings.value() : LogFindings{};
}

/// The one warning about a log, corrected.
Problem only_warning(LaserLog& log, const OpenOfLog& open = {}) {
  const LogFindings findings = findings_in(log, open);
  EXPECT_EQ(findings.warnings.size(), 1U) << to_string(findings.warnings);
  return findings.warnings.empty() ? Problem{} : findings.warnings.front();
}

void expect_same_odometry(const LaserLog& log, const LaserLog& expected, double tolerance) {
  ASSERT_EQ(log.odometry.size(), expected.odometry.size());
  for (std::size_t i = 0; i < log.odometry.size(); ++i) {
    ASSERT_NEAR(log.odometry[i].time_s, expected.odometry[i].time_s, tolerance);
    ASSERT_THAT(log.odometry[i].T_odom_vehicle,
                PoseNear(expected.odometry[i].T_odom_vehicle, tolerance, tolerance));
  }
}

void expect_same_scans(const LaserLog& log, const LaserLog& expected) {
  ASSERT_EQ(log.scans.size(), expected.scans.size());
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    const LaserScanner laser = log.laser_of(log.scans[i]), truth = expected.laser_of(expected.scans[i]);
    ASSERT_EQ(log.scans[i].ranges_m, expected.scans[i].ranges_m);
    ASSERT_NEAR(laser.first_angle_rad, truth.first_angle_rad, 1e-9);
    ASSERT_NEAR(laser.angle_step_rad, truth.angle_step_rad, 1e-9);
  }
}

/// A log that agrees with itself.
void expect_stays_as_it_is(const RecordedDrive& drive) {
  const LaserLog before = drive.log();
  LaserLog log = before;
  const LogFindings findings = findings_in(log);
  EXPECT_THAT(to_string(findings.warnings), IsEmpty());
  EXPECT_FALSE(findings.odometry_by_scans);
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(before.laser().T_vehicle_laser, 0, 0));
  expect_same_odometry(log, before, 0);
  expect_same_scans(log, before);
}

/// Counter-clockwise around the room's pillar, always at the same speed.
Pose2 around_the_pillar(double time_s) {
  constexpr double kTurning_radps = 0.3;
  return Pose2{4, 3, wrap_angle(kTurning_radps * time_s)} * Pose2{0, -1.8, 0};
}

/// There and back in a corridor, with turns on the spot.
Pose2 there_and_back(double time_s) {
  constexpr double kLeg_s = 10, kTurn_s = 4, kSpeed_mps = 0.8;
  const auto rounds = static_cast<int>(time_s / (kLeg_s + kTurn_s));
  const double since_s = time_s - rounds * (kLeg_s + kTurn_s);
  const double leg_m = kSpeed_mps * kLeg_s, at_m = kSpeed_mps * std::min(since_s, kLeg_s);
  const double heading_rad = kPi * (rounds + std::max(0.0, since_s - kLeg_s) / kTurn_s);
  return {rounds % 2 == 0 ? at_m : leg_m - at_m, 0.2, wrap_angle(heading_rad)};
}

LaserScanner mounted_at(const Pose2& T_vehicle_laser) {
  LaserScanner laser = kThreeQuarters;
  laser.T_vehicle_laser = T_vehicle_laser;
  return laser;
}

/// The log of a vehicle of which nothing says where its scanner sits.
LaserLog log_with_unknown_mounting(const Pose2& T_vehicle_laser) {
  LaserLog log = RecordedDrive{.laser = mounted_at(T_vehicle_laser)}.log();
  log.laser().T_vehicle_laser = {};
  return log;
}

void turn_readings_round(LaserLog& log) {
  for (LaserScan& scan : log.scans) std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
}

TEST(LogCorrection, ACleanLogStaysAsItIs) {
  expect_stays_as_it_is({});
  expect_stays_as_it_is({.laser = mounted_at({0.3, -0.1, kPi / 2})});
}

TEST(LogCorrection, ALogWithUsualNoiseStaysAsItIs) {
  expect_stays_as_it_is({.range_sigma_m = 0.03, .odometry_scale = 0.95, .odometry_sigma_rad = 0.5 * kDegree});
}

TEST(LogCorrection, ADelayThatMappingFindsStaysAsItIs) {
  expect_stays_as_it_is({.odometry_late_s = 0.2});
}

TEST(LogCorrection, AMountingThatMappingFindsStaysAsItIs) {
  LaserLog log = log_with_unknown_mounting({0.05, 0.02, 4 * kDegree});
  EXPECT_THAT(findings_in(log).warnings, IsEmpty());
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(Pose2{}, 0, 0));
}

TEST(LogCorrection, SteadyTurningDoesNotShiftTheClock) {
  expect_stays_as_it_is({.T_map_vehicle = around_the_pillar});
  expect_stays_as_it_is(
      {.T_map_vehicle = around_the_pillar, .range_sigma_m = 0.01, .odometry_sigma_rad = 0.3 * kDegree});
}

TEST(LogCorrection, AVehicleThatStandsStaysAsItIs) {
  const auto standing = [](double) { return Pose2{4, 2, 1}; };
  expect_stays_as_it_is({.duration_s = 120, .T_map_vehicle = standing, .range_sigma_m = 0.03});
}

TEST(LogCorrection, ABareCorridorStaysAsItIs) {
  expect_stays_as_it_is(
      {.walls = endless_corridor(), .T_map_vehicle = there_and_back, .range_sigma_m = 0.01});
}

TEST(LogCorrection, ReadingsThatRunClockwiseAreTakenTheOtherWayRound) {
  const LaserLog truth = RecordedDrive{}.log();
  LaserLog log = truth;
  turn_readings_round(log);
  const Problem warning = only_warning(log);
  EXPECT_THAT(warning.what, HasSubstr("clockwise"));
  EXPECT_EQ(warning.where.line, truth.scans.front().line);
  expect_same_scans(log, truth);
  expect_same_odometry(log, truth, 0);
}

/// A vehicle that looks to both sides by turns, recorded by a scanner that measures its readings one after
/// the other and begins with the last one.
LaserLog log_of_reversed_sweeps() {
  const auto looking_round = [](double time_s) {
    const double heading_rad = 0.9 * std::sin(2 * time_s) + 0.7 * std::sin(1.27 * time_s);
    return Pose2{5 + std::sin(0.3 * time_s), 2, heading_rad};
  };
  const RecordedDrive drive{.T_map_vehicle = looking_round};
  LaserLog log = drive.log();
  const double period_s = 0.09 / static_cast<double>(drive.beams);
  for (LaserScan& scan : log.scans) {
    scan.beams = ScanBeams{drive.laser.first_angle_rad, drive.laser.angle_step_rad, -period_s};
    const double middle = 0.5 * static_cast<double>(drive.beams - 1);
    for (std::size_t beam = 0; beam < drive.beams; ++beam) {
      const double time_s = scan.time_s - period_s * (static_cast<double>(beam) - middle);
      const Pose2 T_map_laser = drive.T_map_vehicle(std::max(0.0, time_s)) * drive.laser.T_vehicle_laser;
      const Vec2 ray = unit(T_map_laser.theta + drive.laser.beam_angle(beam));
      scan.ranges_m[beam] = static_cast<float>(cast_ray_m(drive.walls, T_map_laser.position(), ray));
    }
  }
  return log;
}

TEST(LogCorrection, ReadingsMeasuredFromTheLastToTheFirstAreKnownByTheTurns) {
  LaserLog log = log_of_reversed_sweeps();
  const double period_s = log.scans.front().beams->period_s;
  EXPECT_THAT(to_string(findings_in(log).warnings), IsEmpty());
  EXPECT_EQ(log.scans.front().beams->period_s, period_s);
  for (LaserScan& scan : log.scans) scan.beams->period_s = -period_s;
  EXPECT_THAT(only_warning(log).what, HasSubstr("was measured first"));
  EXPECT_EQ(log.scans.front().beams->period_s, period_s);
}

TEST(LogCorrection, AMountingFarOffIsFound) {
  for (const Pose2& truth : {Pose2{0.4, -0.2, 0}, Pose2{-0.3, 0, -kPi}, Pose2{0, 0, 20 * kDegree}}) {
    LaserLog log = log_with_unknown_mounting(truth);
    EXPECT_THAT(only_warning(log).what, HasSubstr("where the scanner sits"));
    EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(truth, 0.02, 0.5 * kDegree));
  }
}

TEST(LogCorrection, AMountingThatIsGivenStays) {
  LaserLog log = log_with_unknown_mounting({0.4, -0.2, 0});
  EXPECT_THAT(findings_in(log, {.mounting = false}).warnings, IsEmpty());
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(Pose2{}, 0, 0));
}

TEST(LogCorrection, OdometryOnAnotherClockIsShiftedToTheScans) {
  const LaserLog truth = RecordedDrive{}.log();
  for (const double late_s : {1.2, -0.5, 8.0}) {
    LaserLog log = RecordedDrive{.odometry_late_s = late_s}.log();
    const Problem warning = only_warning(log);
    EXPECT_THAT(warning.what, HasSubstr(late_s > 0 ? "ahead of" : "behind"));
    EXPECT_EQ(warning.where.line, 1);
    expect_same_odometry(log, truth, 0.021);
  }
}

TEST(LogCorrection, FindsSeveralFaultsAtOnce) {
  const Pose2 truth{0.3, 0.1, kPi / 2};
  LaserLog log = RecordedDrive{.laser = mounted_at(truth), .odometry_late_s = 1}.log();
  log.laser().T_vehicle_laser = {};
  turn_readings_round(log);
  EXPECT_EQ(findings_in(log).warnings.size(), 3U);
  EXPECT_NEAR(log.odometry.front().time_s, 0, 0.021);
  EXPECT_THAT(log.laser().T_vehicle_laser, PoseNear(truth, 0.02, 1 * kDegree));
}

TEST(LogCorrection, TakesTheBeamsWithWhichTheScansTurnAsTheOdometry) {
  const LaserLog truth = RecordedDrive{}.log();
  LaserLog log = truth;
  log.laser().first_angle_rad = -90 * kDegree;
  log.laser().angle_step_rad = 180 * kDegree / 270;
  const std::vector<ScanBeams> others = {{-180 * kDegree, 360 * kDegree / 270},
                                         {-135 * kDegree, 1 * kDegree}};
  EXPECT_THAT(only_warning(log, {.other_beams = others}).what, HasSubstr("field of view of 271 degrees"));
  expect_same_scans(log, truth);
}

TEST(LogCorrection, OdometryThatIsMissingOrStandsIsReplacedByTheScansOwn) {
  const LaserLog truth = RecordedDrive{.laser = mounted_at({0.2, 0, 30 * kDegree})}.log();
  for (const bool missing : {true, false}) {
    LaserLog log = truth;
    for (OdometrySample& sample : log.odometry) sample.T_odom_vehicle = {};
    if (missing) log.odometry.clear();
    const LogFindings findings = findings_in(log);
    EXPECT_TRUE(findings.odometry_by_scans);
    EXPECT_THAT(to_string(findings.warnings), HasSubstr("mapped by the scans alone"));
    ASSERT_EQ(log.odometry.size(), log.scans.size());
    EXPECT_EQ(log.scans.back().odometry_known, log.scans.size());
    const Pose2 driven = between(log.odometry.front().T_odom_vehicle, log.odometry.back().T_odom_vehicle);
    EXPECT_THAT(driven, PoseNear(truth.odometry.back().T_odom_vehicle, 0.03, 0.5 * kDegree));
  }
}

TEST(LogCorrection, ScansTooFarApartCannotReplaceOdometry) {
  LaserLog log = RecordedDrive{}.log();
  log.odometry.clear();
  std::vector<LaserScan> few;
  for (std::size_t i = 0; i < log.scans.size(); i += 40) few.push_back(log.scans[i]);
  log.scans = few;
  SilentProgress progress;
  const auto findings = correct_log(log, {}, progress);
  ASSERT_FALSE(findings.ok());
  EXPECT_THAT(to_string(findings.problems()), HasSubstr("too far apart"));
}

TEST(LogCorrection, OdometryOfAnotherDriveIsSaid) {
  LaserLog log = RecordedDrive{}.log();
  log.odometry = RecordedDrive{.T_map_vehicle = there_and_back}.log().odometry;
  EXPECT_THAT(only_warning(log).what, HasSubstr("one of the two is wrong"));
}

TEST(LogCorrection, ASingleScanWithoutOdometryStands) {
  LaserLog log = RecordedDrive{.duration_s = 0}.log();
  log.odometry.clear();
  EXPECT_THAT(findings_in(log).warnings, IsEmpty());
  EXPECT_EQ(log.odometry.size(), 1U);
}

}  // namespace
}  // namespace aisle
