#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "aisle/simulation/operators/tour_recorder.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

World square_room_with_a_round_trip() {
  World world{.name = "room"};
  for (const Segment2& line : {Segment2{{5, -5}, {5, 5}}, Segment2{{5, 5}, {-5, 5}},
                               Segment2{{-5, 5}, {-5, -5}}, Segment2{{-5, -5}, {5, -5}}}) {
    world.walls.push_back({.floor_edge = line});
  }
  world.tour = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}, {-3, -3}};
  return world;
}

TourRecording recorded(const World& world, const TourParams& params = {}, std::uint64_t seed = 1) {
  SilentProgress progress;
  return record_tour(world, params, seed, progress);
}

OdometryNoiseParams perfect_wheels() {
  return {.distance_error = 0,
          .slip_sigma_m = 0,
          .rotation_error = 0,
          .drift_rad_per_m = 0,
          .drift_sigma_rad = 0,
          .rotation_sigma_rad = 0};
}

TEST(TourRecorder, EveryScanHasItsTruePoseAndItsOdometry) {
  const TourRecording recording = recorded(square_room_with_a_round_trip());
  const LaserLog& log = recording.log;
  ASSERT_GT(log.scans.size(), 200u);
  ASSERT_EQ(log.scans.size(), log.odometry.size());
  ASSERT_EQ(log.scans.size(), recording.T_world_vehicle.size());
  EXPECT_NEAR(log.scan_period_s(), 0.2, 1e-9);
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    EXPECT_EQ(log.scans[i].odometry_known, i + 1);
    EXPECT_EQ(log.scans[i].time_s, log.odometry[i].time_s);
  }
  EXPECT_THAT(recording.T_world_vehicle.front(), PoseNear(Pose2{-3, -3, 0}, 1e-9, 1e-9));
}

TEST(TourRecorder, ScansAreTakenAtTheTruePoses) {
  const TourRecording recording = recorded(square_room_with_a_round_trip());
  for (std::size_t i = 0; i < recording.log.scans.size(); ++i) {
    const double ahead_m = recording.log.scans[i].ranges_m[90];
    if (ahead_m >= recording.log.laser().range_max_m) continue;
    const Vec2 p_world_hit = recording.T_world_vehicle[i] * Vec2(ahead_m, 0);
    EXPECT_NEAR(p_world_hit.cwiseAbs().maxCoeff(), 5, 0.06);
  }
}

TEST(TourRecorder, SameSeedSameLog) {
  const World world = square_room_with_a_round_trip();
  const TourRecording a = recorded(world, {}, 7), b = recorded(world, {}, 7), c = recorded(world, {}, 8);
  ASSERT_EQ(a.log.scans.size(), b.log.scans.size());
  for (std::size_t i = 0; i < a.log.scans.size(); ++i) {
    ASSERT_EQ(a.log.scans[i].ranges_m, b.log.scans[i].ranges_m);
    ASSERT_EQ(a.log.odometry[i].T_odom_vehicle.theta, b.log.odometry[i].T_odom_vehicle.theta);
  }
  EXPECT_NE(a.log.scans[0].ranges_m, c.log.scans[0].ranges_m);
  EXPECT_NE(a.log.odometry.back().T_odom_vehicle.x, c.log.odometry.back().T_odom_vehicle.x);
}

TEST(TourRecorder, PerfectWheelsCountTheTruth) {
  TourParams params;
  params.odometry = perfect_wheels();
  const TourRecording recording = recorded(square_room_with_a_round_trip(), params);
  for (std::size_t i = 0; i < recording.log.scans.size(); ++i) {
    EXPECT_THAT(recording.T_world_vehicle[0] * recording.log.odometry[i].T_odom_vehicle,
                PoseNear(recording.T_world_vehicle[i], 1e-6, 1e-6));
  }
}

TEST(TourRecorder, ADistanceErrorAndADriftShowAfterAStraightDrive) {
  World world = square_room_with_a_round_trip();
  world.tour = {{-4, 0}, {4, 0}};
  TourParams params;
  params.odometry = perfect_wheels();
  params.odometry.distance_error = 0.02;
  params.odometry.drift_rad_per_m = 0.5 * kDegree;
  const TourRecording recording = recorded(world, params);
  const double distance_m = recording.T_world_vehicle.back().x + 4;
  const Pose2 counted = recording.log.odometry.back().T_odom_vehicle;
  EXPECT_NEAR(counted.position().norm(), 1.02 * distance_m, 0.01);
  EXPECT_NEAR(to_degrees(counted.theta), 0.5 * distance_m, 0.01);
}

TEST(TourRecorder, DelayedOdometryIsFromLaterThanItsScan) {
  TourParams params;
  params.odometry = perfect_wheels();
  params.odometry_delay_s = 0.4;  // two scans
  const TourRecording recording = recorded(square_room_with_a_round_trip(), params);
  for (std::size_t i = 0; i + 2 < recording.log.scans.size(); ++i) {
    EXPECT_THAT(recording.T_world_vehicle[0] * recording.log.odometry[i].T_odom_vehicle,
                PoseNear(recording.T_world_vehicle[i + 2], 1e-6, 1e-6));
  }
}

TEST(TourRecorder, TheShippedWheelsAreThoseOfAnOrdinaryRobot) {
  const TourRecording recording = recorded(square_room_with_a_round_trip(), {}, 3);
  const Pose2 counted = recording.T_world_vehicle[0] * recording.log.odometry.back().T_odom_vehicle;
  const double off_m = (counted.position() - recording.T_world_vehicle.back().position()).norm();
  EXPECT_GT(off_m, 0.3);  // after 23 m
  EXPECT_LT(off_m, 5);
}

/// Keeps what was reported last of each task, and interrupts when it is given to.
class WatchedProgress final : public Progress {
 public:
  explicit WatchedProgress(std::string interrupted_task = "")
      : interrupted_task_(std::move(interrupted_task)) {}
  void report(std::string_view task, std::size_t done, std::size_t total) override {
    if (task == interrupted_task_) throw Interrupted{};
    EXPECT_LE(done, total);
    latest[std::string(task)] = {done, total};
  }

  std::map<std::string, std::pair<std::size_t, std::size_t>> latest;

 private:
  std::string interrupted_task_;
};

TEST(TourRecorder, ReportsItsProgress) {
  WatchedProgress progress;
  const std::size_t scans = record_tour(square_room_with_a_round_trip(), {}, 1, progress).log.scans.size();
  EXPECT_EQ(progress.latest["driving"], std::pair(std::size_t{4}, std::size_t{5}));
  EXPECT_EQ(progress.latest["scanning"], std::pair(scans, scans));
}

TEST(TourRecorder, CanBeInterruptedInAllItsWork) {
  for (const char* task : {"driving", "scanning"}) {
    WatchedProgress progress(task);
    EXPECT_THROW(record_tour(square_room_with_a_round_trip(), {}, 1, progress), Interrupted);
  }
}

TEST(TourRecorder, EveryParameterIsDescribed) {
  TourParams params;
  const FieldList fields = fields_of(params);
  EXPECT_EQ(fields.all().size(), 2u + 4u + 6u + 12u);
  EXPECT_EQ(fields.all().back().key, "scanner.height_m");
}

}  // namespace
}  // namespace aisle
