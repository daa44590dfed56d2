#include <gmock/gmock.h>

#include <algorithm>

#include "aisle/learning/walls/scan_tracker.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

std::vector<SensedSegment> seen(std::span<const Segment2> walls, const Pose2& T_map_sensor) {
  std::vector<SensedSegment> view;
  for (const Segment2& wall : walls) {
    SensedSegment s;
    s.segment = T_map_sensor.inverse() * wall;
    s.centroid = s.segment.midpoint();
    s.heading_rad = s.segment.heading();
    s.length_m = s.segment.length();
    s.sigma_offset_m = 0.01;
    s.sigma_heading_rad = 0.01;
    view.push_back(s);
  }
  return view;
}

/// A view of a room of 8 x 5 m with a cupboard, all of it at once.
std::vector<SensedSegment> view_from(const Pose2& T_room_sensor) {
  const std::vector<Segment2> walls = {{{-4, -2}, {4, -2}}, {{4, -2}, {4, 3}},   {{4, 3}, {-4, 3}},
                                       {{-4, 3}, {-4, -2}}, {{1, 2}, {2, 2}},    {{2, 2}, {2, 3}},
                                       {{1, 3}, {1, 2}},    {{-2, -2}, {-2, -1}}};
  return seen(walls, T_room_sensor);
}

/// Tracks a drive whose odometry is the true motion changed by `odometry`; returns the last pose in the room.
template <class Odometry>
Pose2 follow(const std::vector<Pose2>& drive, Odometry odometry, bool orthogonal = true,
             const TrackerParams& params = {}) {
  ScanTracker tracker(params);
  Pose2 T_track_first, T_track_last;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const Pose2 moved = i > 0 ? odometry(between(drive[i - 1], drive[i])) : Pose2{};
    T_track_last = tracker.step(view_from(drive[i]), moved, orthogonal);
    if (i == 0) T_track_first = T_track_last;
  }
  return drive.front() * between(T_track_first, T_track_last);
}

std::vector<Pose2> curve() {
  std::vector<Pose2> drive;
  for (int i = 0; i <= 30; ++i) drive.push_back({-1.5 + 0.08 * i, -0.5, 0.1 + 0.01 * i});
  return drive;
}

TEST(ScanTracker, FollowsADriveThroughARoomDespitePoorOdometry) {
  const Pose2 last = follow(curve(), [](Pose2 motion) {
    return Pose2{1.2 * motion.x, motion.y + 0.01, motion.theta + 0.01};
  });
  EXPECT_THAT(last, PoseNear(curve().back(), 0.02, 0.01));
}

TEST(ScanTracker, AMotionThatIsKnownBetterIsBelievedMore) {
  const auto pose_after = [](double sigma_m) {
    ScanTracker tracker(TrackerParams{});
    tracker.step(view_from({}), {}, true);
    const Mat3 covariance = about({}, sigma_m, 0.001).covariance;
    return tracker.step_by_motion(view_from({0.5, 0, 0}), UncertainPose2{{0.45, 0, 0}, covariance}, true);
  };
  EXPECT_NEAR(pose_after(0.1).x, 0.5, 0.01);
  EXPECT_NEAR(pose_after(0.0005).x, 0.45, 0.01);
}

TEST(ScanTracker, StaysWhereOnlyTheWheelsSpin) {
  const std::vector<Pose2> standing(30, Pose2{0.5, 0.3, 0.2});
  const Pose2 last = follow(standing, [](Pose2) { return Pose2{0.12, 0, 0}; });  // 3.5 m in all
  EXPECT_THAT(last, PoseNear(standing.back(), 0.06, 0.01));
}

/// A view between two walls of 60 m, with the wall across their end if that is in sight.
std::vector<SensedSegment> corridor_view(const Pose2& T_corridor_sensor, bool sees_end) {
  std::vector<Segment2> walls = {{{0, -1}, {60, -1}}, {{60, 1}, {0, 1}}};
  if (sees_end) walls.push_back({{60, -1}, {60, 1}});
  return seen(walls, T_corridor_sensor);
}

TEST(ScanTracker, LearnsTheWheelsScaleWhereTheEndIsInSightAndKeepsIt) {
  ScanTracker tracker({.motion = kReadEveryCycle});
  constexpr double kStep_m = 0.05, kTooLong = 1.03;
  constexpr int kSteps = 1000, kStepsInSight = 400;  // 20 m, then 30 m
  Pose2 first, last;
  for (int i = 0; i <= kSteps; ++i) {
    const double counted_m = i > 0 ? kTooLong * kStep_m : 0;
    last = tracker.step(corridor_view({5 + i * kStep_m, 0.2, 0}, i < kStepsInSight), {counted_m, 0, 0}, true);
    if (i == 0) first = last;
  }
  const double path_m = kSteps * kStep_m;
  EXPECT_NEAR((last.position() - first.position()).norm(), path_m, 0.2);  // 0.9 by the wheels alone
}

/// A view of a 20 m corridor up to 4 m from its middle at `x_m`.
std::vector<SensedSegment> near_view(double x_m) {
  const double begin_m = std::max(0.0, x_m - 4), end_m = std::min(20.0, x_m + 4);
  std::vector<Segment2> walls = {{{begin_m, -1}, {end_m, -1}}, {{end_m, 1}, {begin_m, 1}}};
  if (begin_m == 0) walls.push_back({{0, 1}, {0, -1}});
  if (end_m == 20) walls.push_back({{20, -1}, {20, 1}});
  return seen(walls, {x_m, 0, 0});
}

/// The same with a pillar on its right side.
std::vector<SensedSegment> near_view_with_pillar(double x_m) {
  std::vector<SensedSegment> view = near_view(x_m);
  constexpr double kWestFace_m = 10, kEastFace_m = 10.2;
  std::vector<Segment2> faces;
  if (x_m < kWestFace_m && x_m > kWestFace_m - 4) faces.push_back({{kWestFace_m, -1}, {kWestFace_m, -0.6}});
  if (x_m > kEastFace_m && x_m < kEastFace_m + 4) faces.push_back({{kEastFace_m, -0.6}, {kEastFace_m, -1}});
  for (const SensedSegment& face : seen(faces, {x_m, 0, 0})) view.push_back(face);
  return view;
}

/// From 6 m to 19 m and back, with wheels that count too long, which the tracker learns at the far end.
template <typename View>
ScanTracker out_and_back(double too_long, const View& view) {
  ScanTracker tracker({.motion = kReadEveryCycle});
  constexpr double kStep_m = 0.05;
  double x_m = 6;
  tracker.step(view(x_m), {}, true);
  for (const double turning_m : {19.0, 6.0}) {
    const double step_m = turning_m > x_m ? kStep_m : -kStep_m;
    while (std::abs(turning_m - x_m) > 1e-9) {
      x_m += step_m;
      tracker.step(view(x_m), {too_long * step_m, 0, 0}, true);
    }
  }
  return tracker;
}

TEST(ScanTracker, CorrectsThePathDrivenBeforeItKnewTheWheelsScale) {
  constexpr double kTooLong = 1.015;
  const ScanTracker tracker = out_and_back(kTooLong, near_view);
  const Keyframe &first = tracker.keyframes().front(), &last = tracker.keyframes().back();
  EXPECT_NEAR(tracker.odometry_factor(), 1 / kTooLong, 0.005);
  EXPECT_GT(between(first.T_track_sensor, last.T_track_sensor).position().norm(), 0.1);
  EXPECT_LT(relative_pose(first, last, tracker.odometry_factor()).position().norm(), 0.05);
}

TEST(ScanTracker, CountsTheWayBackFromWhatItSawOnTheWayOut) {
  constexpr double kTooLong = 1.015;
  const ScanTracker tracker = out_and_back(kTooLong, near_view_with_pillar);
  const Keyframe &first = tracker.keyframes().front(), &last = tracker.keyframes().back();
  EXPECT_NEAR(tracker.odometry_factor(), 1 / kTooLong, 0.003);
  EXPECT_LT(relative_pose(first, last, tracker.odometry_factor()).position().norm(), 0.02);
}

/// A drive of 40 scans; from the 20th on, some are taken from a displaced pose that the odometry does not
/// show.
/// @return for each scan, how far the tracked pose is from the pose it was taken at
std::vector<double> off_after_displaced_views_m(const Pose2& displacement, int views) {
  ScanTracker tracker(TrackerParams{});
  std::vector<double> off_m;
  Pose2 T_room_track;
  for (int i = 0; i < 40; ++i) {
    const Pose2 T_room_sensor{-1.5 + 0.05 * i, -0.5, 0};
    const bool is_displaced = i >= 20 && i < 20 + views;
    const Pose2 seen_from = is_displaced ? T_room_sensor * displacement : T_room_sensor;
    const Pose2 T_track_sensor = tracker.step(view_from(seen_from), {i > 0 ? 0.05 : 0.0, 0, 0}, true);
    if (i == 0) T_room_track = T_room_sensor * T_track_sensor.inverse();
    off_m.push_back(((T_room_track * T_track_sensor).position() - seen_from.position()).norm());
  }
  return off_m;
}

TEST(ScanTracker, FindsItselfWhereTheOdometryHasMissedAMotion) {
  const std::vector<double> off_m = off_after_displaced_views_m({0.5, 0.8, 0}, 20);
  EXPECT_GT(off_m[20], 0.5);
  EXPECT_LT(off_m[28], 0.03) << "after 40 cm";
  EXPECT_LT(off_m.back(), 0.03);
}

TEST(ScanTracker, IsNotMisledByOneScanThatFitsWellElsewhere) {
  const std::vector<double> off_m = off_after_displaced_views_m({0.5, 0.8, 0}, 1);
  EXPECT_GT(off_m[20], 0.5) << "from where that scan was taken";
  for (std::size_t i = 21; i < off_m.size(); ++i) EXPECT_LT(off_m[i], 0.15) << i;
  EXPECT_LT(off_m.back(), 0.03);
}

TEST(ScanTracker, IsNotMisledByScansOfOnePlaceThatFitWellElsewhere) {
  const int views = 5;  // within 20 cm
  const std::vector<double> off_m = off_after_displaced_views_m({0.5, 0.8, 0}, views);
  for (std::size_t i = 20; i < 20 + views; ++i) EXPECT_GT(off_m[i], 0.5) << i;
  EXPECT_LT(off_m.back(), 0.03);
}

TEST(ScanTracker, NeedsNoAxes) {
  const Pose2 last = follow(
      curve(),
      [](Pose2 motion) {
        return Pose2{1.1 * motion.x, motion.y, motion.theta};
      },
      false);
  EXPECT_THAT(last, PoseNear(curve().back(), 0.02, 0.01));
}

TEST(ScanTracker, LaysAnEarlierScanOntoTheWallsAgain) {
  ScanTracker tracker(TrackerParams{});
  const std::vector<Pose2> drive = curve();
  Pose2 T_track_last;
  for (std::size_t i = 0; i < drive.size(); ++i)
    T_track_last = tracker.step(view_from(drive[i]), i > 0 ? between(drive[i - 1], drive[i]) : Pose2{}, true);
  const Pose2 T_room_track = drive.back() * T_track_last.inverse();
  const auto first = tracker.lay_again(view_from(drive.front()),
                                       T_room_track.inverse() * drive.front() * Pose2{0.1, -0.08, 0.03});
  ASSERT_TRUE(first);
  EXPECT_THAT(T_room_track * *first, PoseNear(drive.front(), 0.01, 0.003));
}

/// Along a corridor only an open door's leaf gives the position, and it may have been learned 10 cm off.
TEST(ScanTracker, KeepsTheGuessOfAnEarlierScanAlongACorridor) {
  ScanTracker tracker(TrackerParams{});
  const auto view = [](double x_m, double leaf_x_m) {
    return seen(
        std::vector<Segment2>{
            {{0, -1}, {60, -1}}, {{60, 1}, {0, 1}}, {{leaf_x_m + 0.5, 0.7}, {leaf_x_m, 0.9}}},
        {x_m, 0, 0});
  };
  constexpr double kStart_m = 8, kLeaf_m = 10;
  for (int i = 0; i <= 20; ++i)
    tracker.step(view(kStart_m + 0.08 * i, kLeaf_m), {i > 0 ? 0.08 : 0, 0, 0}, true);
  const auto first = tracker.lay_again(view(kStart_m, kLeaf_m + 0.1), {});
  ASSERT_TRUE(first);
  EXPECT_THAT(*first, PoseNear(Pose2{}, 0.04, 0.01));
}

TEST(ScanTracker, DoesNotLayAScanOfAnotherRoomOntoTheWalls) {
  ScanTracker tracker(TrackerParams{});
  tracker.step(view_from({}), {}, true);
  std::vector<SensedSegment> elsewhere = view_from({});
  for (SensedSegment& s : elsewhere) {
    s.segment = Pose2{0, 0, 0.6} * s.segment;
    s.centroid = s.segment.midpoint();
    s.heading_rad = s.segment.heading();
  }
  EXPECT_FALSE(tracker.lay_again(elsewhere, {}));
  EXPECT_FALSE(tracker.lay_again({}, {}));
}

TEST(ScanTracker, WithNothingInSightItFollowsTheOdometry) {
  ScanTracker tracker(TrackerParams{});
  tracker.step({}, {}, true);
  Pose2 last;
  for (int i = 0; i < 10; ++i) last = tracker.step({}, {0.1, 0, 0.05}, true);
  Pose2 expected;
  for (int i = 0; i < 10; ++i) expected = expected * Pose2{0.1, 0, 0.05};
  EXPECT_THAT(last, PoseNear(expected, 1e-9, 1e-9));
}

}  // namespace
}  // namespace aisle
