#include "aisle/formats/logs/bee_log.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/formats/logs/read_laser_recording.hpp"
#include "session_samples.hpp"
#include "written_file.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// 20 scans, 0.2 s and 10 cm apart, of a laser 25 cm ahead of a robot that drives along y.
std::string bee_log() {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    text += fmt::format("L 100 {} 1.570796327 100 {} 1.570796327", 10 * i, 10 * i + 25);
    for (int k = 0; k < 180; ++k) text += fmt::format(" {}", 300 + k);
    text += fmt::format(" {:.6f}\nO 100 {} 1.570796327 {:.6f}\n", 0.2 * i, 10 * i + 5, 0.2 * i + 0.1);
  }
  return text;
}

TEST(BeeLog, GivesScansAndTheirPosesInMetres) {
  ASSERT_TRUE(begins_bee_log(bee_log()));
  const auto recording = parse_bee_log(bee_log(), "robotdata.log");
  ASSERT_TRUE(recording.ok()) << to_string(recording.problems());
  EXPECT_EQ(to_string(recording->warnings), "");
  const LaserLog& log = recording->log;
  ASSERT_EQ(log.scans.size(), 20U);
  ASSERT_EQ(log.scans[0].ranges_m.size(), 180U);
  EXPECT_FLOAT_EQ(log.scans[0].ranges_m[5], 3.05F);
  EXPECT_NEAR(log.laser().first_angle_rad, -kPi / 2, 1e-9) << "from the right";
  EXPECT_NEAR(log.laser().angle_step_rad, kDegree, 1e-9) << "to the left";
  EXPECT_NEAR(log.laser().T_vehicle_laser.x, 0.25, 1e-6);
  EXPECT_NEAR(log.laser().T_vehicle_laser.y, 0, 1e-6);
  EXPECT_TRUE(recording->has_mounting);
  ASSERT_EQ(log.odometry.size(), 20U);
  EXPECT_NEAR(log.odometry.back().T_odom_vehicle.y, 1.9, 1e-9);
  EXPECT_NEAR(log.scans[3].time_s, 0.6, 1e-9);
}

TEST(BeeLog, LinesThatCannotBeReadAreLeftOutAndSaid) {
  const std::string text = bee_log() + "L 1 2 3\nnoise\nL 100 200 1.57 100 225 1.57 300 30";
  const auto recording = parse_bee_log(text, "robotdata.log");
  ASSERT_TRUE(recording.ok());
  EXPECT_EQ(recording->log.scans.size(), 20U);
  EXPECT_THAT(
      to_string(recording->warnings),
      HasSubstr("robotdata.log:41: has too few numbers for a scan; lines that cannot be read are left "
                "out: 3"));
}

TEST(BeeLog, AReadingThatIsNoDistanceTellsNothing) {
  std::string text = bee_log();
  text.replace(text.find(" 305 "), 5, " nan ");
  const auto recording = parse_bee_log(text, "robotdata.log");
  ASSERT_TRUE(recording.ok());
  EXPECT_EQ(recording->log.scans.size(), 20U);
  EXPECT_EQ(recording->log.scans[0].ranges_m[5], 0);
  EXPECT_THAT(to_string(recording->warnings), HasSubstr("robotdata.log:1: 1 readings are NaN"));
}

TEST(BeeLog, IsToldByItsContentAndOtherTextsAreNot) {
  const SessionPlace place;
  write_file(place / "robotdata.log", bee_log());
  EXPECT_TRUE(is_laser_recording(place / "robotdata.log"));
  EXPECT_TRUE(read_laser_recording(place / "robotdata.log").ok());
  EXPECT_FALSE(begins_bee_log("O 1 2 3 4\n"));
  EXPECT_FALSE(
      begins_bee_log("L landmarks are here, and this goes on and on for more than seventeen words, see\n"));
  EXPECT_FALSE(begins_bee_log("L C 12.0 400 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n"))
      << "landmarks of a Lego log";
}

TEST(BeeLog, WithoutAScanIsRefused) {
  EXPECT_FALSE(parse_bee_log("O 1 2 3 4\n", "x").ok());
  EXPECT_FALSE(parse_bee_log("", "x").ok());
}

}  // namespace
}  // namespace aisle
