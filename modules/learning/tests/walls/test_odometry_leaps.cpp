#include "walls/odometry_leaps.hpp"

#include <gmock/gmock.h>

#include <string>

#include "pose_matchers.hpp"
#include "walls/recorded_drive.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// The samples of the odometry from `first` on in another frame.
void restart(LaserLog& log, std::size_t first, const Pose2& T_new_old) {
  for (std::size_t i = first; i < log.odometry.size(); ++i)
    log.odometry[i].T_odom_vehicle = T_new_old * log.odometry[i].T_odom_vehicle;
}

/// The sample `first` and those behind it begin again at zero.
void restart_at_zero(LaserLog& log, std::size_t first) {
  restart(log, first, log.odometry[first].T_odom_vehicle.inverse());
}

/// The samples from `first` to before `end` repeat the one before them.
void freeze(LaserLog& log, std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i)
    log.odometry[i].T_odom_vehicle = log.odometry[first - 1].T_odom_vehicle;
}

void see_nothing(LaserLog& log) {
  for (LaserScan& scan : log.scans) std::fill(scan.ranges_m.begin(), scan.ranges_m.end(), 0.0F);
}

/// The largest difference from the true odometry.
Pose2 worst_difference(const LaserLog& log, const LaserLog& truth) {
  Pose2 worst;
  for (std::size_t i = 0; i < log.odometry.size(); ++i) {
    const Pose2 off = between(truth.odometry[i].T_odom_vehicle, log.odometry[i].T_odom_vehicle);
    if (off.position().norm() > worst.position().norm()) worst = off;
  }
  return worst;
}

LaserLog usual_log() {
  return RecordedDrive{.laser = {-135 * kDegree, 1 * kDegree, 30, {0.3, -0.1, 40 * kDegree}},
                       .range_sigma_m = 0.01}
      .log();
}

TEST(OdometryLeaps, OdometryThatDoesNotLeapStaysAsItIs) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  EXPECT_THAT(correct_leaps(log), IsEmpty());
  for (std::size_t i = 0; i < log.odometry.size(); ++i)
    ASSERT_THAT(log.odometry[i].T_odom_vehicle, PoseNear(truth.odometry[i].T_odom_vehicle, 1e-12, 1e-12));
}

TEST(OdometryLeaps, ARestartAtZeroGoesOnWhereItWas) {
  const LaserLog truth = usual_log();
  for (const std::size_t sample : {200, 201, 450}) {
    LaserLog log = truth;
    restart_at_zero(log, sample);
    const Problems warnings = correct_leaps(log);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("the scans before and after tell"));
    EXPECT_EQ(warnings[0].where.line, truth.odometry[sample].line);
    EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 0.12, 2 * kDegree));
  }
}

TEST(OdometryLeaps, ALeapOfTheHeadingAloneIsOne) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  const Pose2 there = log.odometry[300].T_odom_vehicle;
  restart(log, 300, there * Pose2{0, 0, 90 * kDegree} * there.inverse());
  EXPECT_EQ(correct_leaps(log).size(), 1U);
  EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 0.12, 2 * kDegree));
}

TEST(OdometryLeaps, MotionAfterALeapIsAsCounted) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  restart(log, 300, {4, -2, 2});
  correct_leaps(log);
  for (std::size_t i = 301; i < log.odometry.size(); ++i) {
    ASSERT_THAT(
        between(log.odometry[300].T_odom_vehicle, log.odometry[i].T_odom_vehicle),
        PoseNear(between(truth.odometry[300].T_odom_vehicle, truth.odometry[i].T_odom_vehicle), 1e-9, 1e-9));
  }
}

TEST(OdometryLeaps, MotionCaughtUpWithIsSpreadOverTheTimeInWhichItStoodStill) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  freeze(log, 301, 340);  // 2 s
  const Problems warnings = correct_leaps(log);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].what, HasSubstr("after 2.0 s in which it stood still"));
  EXPECT_EQ(warnings[0].where.line, truth.odometry[340].line);
  EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 0.25, 20 * kDegree));
  EXPECT_THAT(log.odometry[340].T_odom_vehicle, PoseNear(truth.odometry[340].T_odom_vehicle, 1e-9, 1e-9));
  EXPECT_THAT(log.odometry.back().T_odom_vehicle, PoseNear(truth.odometry.back().T_odom_vehicle, 1e-9, 1e-9));
}

TEST(OdometryLeaps, ABadConnectionIsMendedEveryTime) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  for (std::size_t first = 101; first < 700; first += 100) freeze(log, first, first + 25);
  correct_leaps(log);
  EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 0.1, 10 * kDegree));
}

TEST(OdometryLeaps, AStepThatTheScansConfirmStays) {
  const auto hurried = [](double time_s) { return on_figure_of_eight(time_s < 15 ? time_s : time_s + 1); };
  const LaserLog truth = RecordedDrive{.T_map_vehicle = hurried}.log();
  LaserLog log = truth;
  EXPECT_THAT(correct_leaps(log), IsEmpty());
  EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 1e-9, 1e-9));
}

TEST(OdometryLeaps, ALeapThatTheScansCannotTellIsTakenForStandingStill) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  restart(log, 300, {4, -2, 0});
  see_nothing(log);
  const Problems warnings = correct_leaps(log);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].what, HasSubstr("taken for standing still"));
  EXPECT_THAT(log.odometry[300].T_odom_vehicle, PoseNear(truth.odometry[299].T_odom_vehicle, 1e-9, 1e-9));
  EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 0.2, 5 * kDegree));
}

TEST(OdometryLeaps, WhatStoodStillCatchesUpEvenIfTheScansCannotTell) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  freeze(log, 301, 340);
  see_nothing(log);
  EXPECT_THAT(to_string(correct_leaps(log)), HasSubstr("after 2.0 s in which it stood still"));
  EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 0.25, 20 * kDegree));
}

TEST(OdometryLeaps, FiveAreToldAndTheRestCounted) {
  const LaserLog truth = usual_log();
  LaserLog log = truth;
  for (std::size_t first = 60; first < 800; first += 90) restart(log, first, {3, 3, 1});  // nine
  const Problems warnings = correct_leaps(log);
  ASSERT_EQ(warnings.size(), 6U);
  EXPECT_THAT(warnings.back().what, HasSubstr("at 4 more places"));
  EXPECT_THAT(worst_difference(log, truth), PoseNear(Pose2{}, 0.6, 10 * kDegree));
}

TEST(OdometryLeaps, AreCorrectedAlikeInAnyFrameOfTheOdometry) {
  const Pose2 T_other_odom{-20, 7, 2.5};
  LaserLog log = usual_log();
  restart(log, 200, {4, -2, 1});
  freeze(log, 501, 540);
  LaserLog other = log;
  restart(other, 0, T_other_odom);
  EXPECT_EQ(correct_leaps(log).size(), 2U);
  EXPECT_EQ(correct_leaps(other).size(), 2U);
  restart(other, 0, T_other_odom.inverse());
  EXPECT_THAT(worst_difference(other, log), PoseNear(Pose2{}, 1e-9, 1e-9));
}

TEST(OdometryLeaps, ThoseWithoutScansOnBothSidesStay) {
  LaserLog log = usual_log();
  restart(log, 1, {4, -2, 1});
  log.scans.clear();
  EXPECT_THAT(correct_leaps(log), IsEmpty());
  log.odometry.resize(1);
  EXPECT_THAT(correct_leaps(log), IsEmpty());
}

}  // namespace
}  // namespace aisle
