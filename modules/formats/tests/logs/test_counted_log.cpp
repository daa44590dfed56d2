#include "aisle/formats/logs/counted_log.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"
#include "session_samples.hpp"
#include "written_file.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

std::string readings(int count, int reading_mm) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format(" {}", reading_mm + i % 50);
  return text;
}

/// 20 lines, 0.1 s apart. Per line the wheels count so many.
std::string coreslam(int left, int right) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += fmt::format("{} 14710 {} {} 0 0 0 170.1{} {} \n", 212387282 + 100000 * i, 29221 + left * i,
                        25178 + right * i, " 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0", readings(683, 1500));
  return text;
}

std::string lego_motors() {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += fmt::format("M {} {} {} 3000 0 {} {} 3000 0 0 0 6000 0\n", 204 + 200 * i, 20795 + 100 * i,
                        20795 + 100 * i, 16067 + 100 * i, 16066 + 100 * i);
  return text;
}

std::string lego_scans(bool with_count = true) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += fmt::format("S {}{}{}\n", 315 + 200 * i, with_count ? " 660" : "", readings(660, 189));
  return text;
}

TEST(CoreslamLog, GivesScansAndWhatTheWheelsCounted) {
  ASSERT_TRUE(begins_coreslam_log(coreslam(0, 0)));
  const auto recording = parse_coreslam_log(coreslam(100, 100), "exp.dat");
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  const LaserLog& log = recording->log;
  ASSERT_EQ(log.scans.size(), 20U);
  EXPECT_NEAR(log.scans[3].time_s - log.scans[2].time_s, 0.1, 1e-9);
  ASSERT_EQ(log.scans[0].ranges_m.size(), 683U);
  EXPECT_FLOAT_EQ(log.scans[0].ranges_m[1], 1.501F);
  EXPECT_NEAR(log.laser().first_angle_rad + 341 * log.laser().angle_step_rad, 0, 1e-9) << "straight ahead";
  EXPECT_NEAR(log.laser().T_vehicle_laser.x, 0.145, 1e-9);
  const double turns = 19 * 100 / 2000.0;
  EXPECT_NEAR(log.odometry.back().T_odom_vehicle.x, turns * 2 * kPi * 0.077, 1e-9);
  EXPECT_NEAR(log.odometry.back().T_odom_vehicle.theta, 0, 1e-9);
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("does not say how its robot counts"));
}

TEST(CoreslamLog, TheRightWheelTurnsItToTheLeft) {
  const auto recording = parse_coreslam_log(coreslam(-10, 10), "exp.dat");
  const double arc_m = 19 * 10 / 2000.0 * 2 * kPi * 0.077;
  EXPECT_NEAR(recording->log.odometry.back().T_odom_vehicle.theta, arc_m / 0.165, 1e-9);
}

TEST(CoreslamLog, ErrorCodesTellNothing) {
  std::string text = coreslam(1, 1);
  text.replace(text.find(" 1501 "), 6, " 2 ");
  const auto recording = parse_coreslam_log(text, "exp.dat");
  EXPECT_EQ(recording->log.scans[0].ranges_m[1], 0);
}

TEST(CoreslamLog, LinesThatCannotBeReadAreLeftOutAndSaid) {
  std::string text = coreslam(1, 1) + "hello world\n" + coreslam(1, 1).substr(0, 50);
  const auto recording = parse_coreslam_log(text, "exp.dat");
  ASSERT_TRUE(recording.ok());
  EXPECT_EQ(recording->log.scans.size(), 20U);
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("exp.dat:21: "));
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("lines that cannot be read are left out: 2"));
  EXPECT_THAT(to_string(parse_coreslam_log("1 2 3\n", "exp.dat").problems()), HasSubstr("has no scan"));
}

TEST(LegoLog, ScansAndMotorsAreTwoFilesOfOneFolder) {
  const SessionPlace place;
  write_file(place / "run/robot4_scan.txt", lego_scans());
  write_file(place / "run/robot4_motors.txt", lego_motors());
  write_file(place / "run/robot4_reference.txt", "P 378 1850 1897\nP 494 1853 1897\n");
  const auto recording = read_laser_recording(place / "run");
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_EQ(recording->log.scans.size(), 20U);
  EXPECT_EQ(recording->log.scans[0].ranges_m.size(), 660U);
  ASSERT_EQ(recording->log.odometry.size(), 20U);
  EXPECT_NEAR(recording->log.odometry.back().T_odom_vehicle.x, 1900 * 0.000349, 1e-9);
  EXPECT_EQ(recording->log.scans[0].odometry_known, 1U) << "the motors' record before";
  EXPECT_FALSE(read_laser_recording(place / "run", {.scan_topic = "/scan"}).ok());
}

TEST(LegoLog, ScansAloneHaveNoOdometryAndMotorsAloneNoScan) {
  const SessionPlace place;
  write_file(place / "scan.txt", lego_scans(false));
  write_file(place / "motors.txt", lego_motors());
  const auto scans = read_laser_recording(place / "scan.txt");
  ASSERT_TRUE(scans.ok()) << to_string(scans.problems());
  EXPECT_TRUE(scans->log.odometry.empty());
  EXPECT_EQ(scans->log.scans[0].ranges_m.size(), 660U) << "without the number of readings";
  EXPECT_THAT(to_string(read_laser_recording(place / "motors.txt").problems()),
              HasSubstr("motors.txt: has no scan that can be read"));
}

TEST(CountedLogs, SurviveFlippedBytes) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    std::string text = i % 2 == 0 ? coreslam(3, 4) : lego_motors() + lego_scans();
    for (int flip = 0; flip < 20; ++flip) text[random.index(text.size())] = static_cast<char>(random.bits());
    (void)parse_coreslam_log(text, "flipped");
    (void)parse_lego_log({{text}}, "flipped");
  }
}

}  // namespace
}  // namespace aisle
