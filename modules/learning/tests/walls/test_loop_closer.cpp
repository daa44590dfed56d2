#include "walls/loop_closer.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::Not;

constexpr double kKeyframe_m = 0.25;
constexpr std::size_t kKeyframesPerSubmap = 16;
constexpr double kSight_m = 3.5;

/// A drive in steps of 0.25 m: where it truly went, and what was tracked.
struct TrackedDrive {
  std::vector<Pose2> T_map_sensor;
  std::vector<Keyframe> keyframes;
};

/// The drive from corner to corner, tracked without an error.
TrackedDrive drive_past(const std::vector<Vec2>& corners) {
  TrackedDrive drive;
  double path_m = 0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Vec2 leg = corners[i + 1] - corners[i];
    const auto steps = static_cast<int>(std::lround(leg.norm() / kKeyframe_m));
    for (int step = 0; step < steps; ++step, path_m += kKeyframe_m) {
      const Vec2 at = corners[i] + leg * step / steps;
      drive.T_map_sensor.push_back({at.x(), at.y(), heading_of(leg)});
      drive.keyframes.push_back(
          {.scan = drive.keyframes.size(), .T_track_sensor = drive.T_map_sensor.back(), .path_m = path_m});
    }
  }
  return drive;
}

/// The track slips by these shares of the path along x and along y, whichever way it leads.
void add_slip(double share_x, double share_y, TrackedDrive& drive) {
  Vec2 off = Vec2::Zero();
  for (std::size_t k = 1; k < drive.keyframes.size(); ++k) {
    const Vec2 step = drive.T_map_sensor[k].position() - drive.T_map_sensor[k - 1].position();
    off += Vec2(share_x * std::abs(step.x()), share_y * std::abs(step.y()));
    drive.keyframes[k].T_track_sensor.x += off.x();
    drive.keyframes[k].T_track_sensor.y += off.y();
  }
}

/// The heading drifts by this much per metre.
void add_turn(double rad_per_m, TrackedDrive& drive) {
  for (std::size_t k = 1; k < drive.keyframes.size(); ++k) {
    Pose2 step = between(drive.T_map_sensor[k - 1], drive.T_map_sensor[k]);
    step.theta = wrap_angle(step.theta + rad_per_m * step.position().norm());
    drive.keyframes[k].T_track_sensor = drive.keyframes[k - 1].T_track_sensor * step;
  }
}

/// Truth and track, both in another frame.
TrackedDrive moved_by(const Pose2& T, TrackedDrive drive) {
  for (Pose2& pose : drive.T_map_sensor) pose = T * pose;
  for (Keyframe& keyframe : drive.keyframes) keyframe.T_track_sensor = T * keyframe.T_track_sensor;
  return drive;
}

/// The part of a segment on an axis within a square around `middle`; of no length if there is none.
Segment2 part_near(const Segment2& segment, const Vec2& middle) {
  const auto clamp = [&](const Vec2& p) -> Vec2 {
    return p.cwiseMax(middle - Vec2::Constant(kSight_m)).cwiseMin(middle + Vec2::Constant(kSight_m));
  };
  const Segment2 part{clamp(segment.start), clamp(segment.end)};
  return segment.distance(part.start) < 1e-9 ? part : Segment2{};
}

/// The submap of the true walls around its middle, exact in itself. `T_map_building` turns a building whose
/// walls are on the axes.
Submap submap_seen(const TrackedDrive& drive, std::size_t first, const std::vector<Segment2>& building,
                   const Pose2& T_map_building, bool orthogonal) {
  Submap submap;
  submap.first_keyframe = first;
  submap.last_keyframe = first + kKeyframesPerSubmap - 1;
  submap.anchor_keyframe = first + kKeyframesPerSubmap / 2;
  const Keyframe& anchor = drive.keyframes[submap.anchor_keyframe];
  const Pose2& T_map_anchor = drive.T_map_sensor[submap.anchor_keyframe];
  submap.T_track_anchor = anchor.T_track_sensor;
  submap.path_m = anchor.path_m;
  const Vec2 at = (T_map_building.inverse() * T_map_anchor).position();
  for (const Segment2& whole : building) {
    const Segment2 near = part_near(whole, at);
    if (near.length() < 0.1) continue;
    const Segment2 tracked = submap.T_track_anchor * T_map_anchor.inverse() * T_map_building * near;
    WallEstimate wall;
    wall.set_heading(tracked.heading());
    if (orthogonal) wall.facing = facing_of(wall.heading_rad, 1 * kDegree);
    wall.anchor = tracked.midpoint();
    wall.extent = {-tracked.length() / 2, tracked.length() / 2};
    wall.sightings = 5;
    submap.walls.push_back(wall);
  }
  return submap;
}

/// Takes all submaps of a drive.
LoopCloser closer_of(const TrackedDrive& drive, const std::vector<Segment2>& building,
                     const LoopParams& params = {}, const Pose2& T_map_building = {},
                     bool orthogonal = true) {
  LoopCloser closer(params, MotionNoise{});
  for (std::size_t first = 0; first + kKeyframesPerSubmap <= drive.keyframes.size();
       first += kKeyframesPerSubmap) {
    const std::size_t closed = closer.closures().size();
    const bool any = closer.add(submap_seen(drive, first, building, T_map_building, orthogonal),
                                std::span(drive.keyframes).first(first + kKeyframesPerSubmap), orthogonal);
    EXPECT_EQ(any, closer.closures().size() > closed);
  }
  return closer;
}

/// The anchor's true pose, if the first anchor's is as tracked.
Pose2 true_anchor(const LoopCloser& closer, const TrackedDrive& drive, std::size_t submap) {
  const auto T_map = [&](std::size_t i) { return drive.T_map_sensor[closer.submaps()[i].anchor_keyframe]; };
  return closer.T_map_anchor(0) * between(T_map(0), T_map(submap));
}

double worst_anchor_m(const LoopCloser& closer, const TrackedDrive& drive) {
  double worst_m = 0;
  for (std::size_t i = 0; i < closer.submaps().size(); ++i) {
    const Pose2 error = between(true_anchor(closer, drive, i), closer.T_map_anchor(i));
    worst_m = std::max(worst_m, error.position().norm());
  }
  return worst_m;
}

constexpr double kLoop_m = 0.02, kLoop_rad = 0.3 * kDegree;  // what a loop is trusted with at best

/// Where the vehicle truly came to the same place again, it does so on the map. How the drift in between was
/// spread over the path, a loop leaves open.
void expect_meets_itself(const LoopCloser& closer, const TrackedDrive& drive) {
  std::size_t meetings = 0;
  for (std::size_t newer = 0; newer < closer.submaps().size(); ++newer) {
    for (std::size_t older = 0; older < newer; ++older) {
      const Pose2 truth = between(true_anchor(closer, drive, older), true_anchor(closer, drive, newer));
      if (truth.position().norm() > 0.1) continue;
      ++meetings;
      EXPECT_THAT(between(closer.T_map_anchor(older), closer.T_map_anchor(newer)),
                  PoseNear(truth, kLoop_m, kLoop_rad))
          << older << " " << newer;
    }
  }
  EXPECT_GE(meetings, 3U);
}

void expect_as_tracked(const LoopCloser& closer) {
  for (std::size_t i = 0; i < closer.submaps().size(); ++i)
    EXPECT_THAT(closer.T_map_anchor(i), PoseNear(closer.submaps()[i].T_track_anchor, 1e-9, 1e-9)) << i;
}

/// A corridor 2 m wide around a block of 12 x 6 m, with cupboards at irregular distances.
std::vector<Segment2> ring_of_corridors() {
  std::vector<Segment2> walls = {{{0, 0}, {16, 0}}, {{16, 0}, {16, 10}}, {{16, 10}, {0, 10}},
                                 {{0, 10}, {0, 0}}, {{14, 2}, {2, 2}},   {{2, 2}, {2, 8}},
                                 {{2, 8}, {14, 8}}, {{14, 8}, {14, 2}}};
  for (const double x : {3.1, 4.9, 7.2, 8.3, 10.8, 12.4}) {
    walls.push_back({{x, 0.6}, {x, 0}});
    walls.push_back({{17 - x, 9.4}, {17 - x, 10}});
  }
  for (const double y : {3.3, 4.6, 6.9}) {
    walls.push_back({{15.4, y}, {16, y}});
    walls.push_back({{0.6, y + 0.5}, {0, y + 0.5}});
  }
  return walls;
}

/// Once around, and 16 m more.
TrackedDrive drive_around() {
  return drive_past({{8, 1}, {15, 1}, {15, 9}, {1, 9}, {1, 1}, {15, 1}, {15, 9}, {14, 9}});
}

/// Two walls 30 m long, and something across one of them at these distances.
std::vector<Segment2> corridor_with(const std::vector<double>& pillars_m) {
  std::vector<Segment2> walls = {{{-5, -1}, {35, -1}}, {{35, 1}, {-5, 1}}};
  for (const double x : pillars_m) {
    walls.push_back({{x, -0.4}, {x, -1}});
    walls.push_back({{x, 1}, {x, 0.4}});
  }
  return walls;
}

/// Along the corridor and back.
TrackedDrive drive_there_and_back() {
  return drive_past({{0, 0}, {24, 0}, {0, 0}});
}

TEST(LoopCloser, ClosesALoopWithKnownDriftToTheTruth) {
  TrackedDrive drive = drive_around();
  add_slip(0.01, -0.012, drive);
  LoopCloser closer = closer_of(drive, ring_of_corridors());
  EXPECT_THAT(closer.closures(), Not(IsEmpty()));
  const std::size_t last = closer.submaps().size() - 1;
  EXPECT_THAT(closer.submaps()[last].T_track_anchor, Not(PoseNear(true_anchor(closer, drive, last), 0.4, 1)));
  const double tracked_worst_m = worst_anchor_m(closer_of(drive, {}), drive);
  closer.finish(drive.keyframes);
  expect_meets_itself(closer, drive);
  EXPECT_LT(worst_anchor_m(closer, drive), tracked_worst_m / 4);
}

TEST(LoopCloser, WithoutAxesItClosesALoopWhoseHeadingDrifted) {
  const Pose2 T_map_building{3, -2, 0.5};
  TrackedDrive drive = moved_by(T_map_building, drive_around());
  add_turn(0.04 * kDegree, drive);
  LoopCloser closer = closer_of(drive, ring_of_corridors(), {}, T_map_building, false);
  EXPECT_THAT(closer.closures(), Not(IsEmpty()));
  const std::size_t last = closer.submaps().size() - 1;
  EXPECT_THAT(closer.submaps()[last].T_track_anchor,
              Not(PoseNear(true_anchor(closer, drive, last), 0.2, 1.5 * kDegree)));
  closer.finish(drive.keyframes);
  expect_meets_itself(closer, drive);
  EXPECT_LT(worst_anchor_m(closer, drive), 0.05);
}

TEST(LoopCloser, ExactTracksStayExact) {
  const TrackedDrive drive = drive_around();
  LoopCloser closer = closer_of(drive, ring_of_corridors());
  closer.finish(drive.keyframes);
  EXPECT_THAT(closer.closures(), Not(IsEmpty()));
  for (std::size_t i = 0; i < closer.submaps().size(); ++i)
    EXPECT_THAT(closer.T_map_anchor(i), PoseNear(true_anchor(closer, drive, i), 1e-6, 1e-6)) << i;
}

TEST(LoopCloser, ClosesTheSameLoopsAfterACommonMotion) {
  TrackedDrive drive = drive_around();
  add_slip(0.01, -0.012, drive);
  const Pose2 T_turned_first{-40, 25, 0.8};
  const TrackedDrive turned_drive = moved_by(T_turned_first, drive);
  LoopCloser first = closer_of(drive, ring_of_corridors(), {}, {}, false);
  LoopCloser turned = closer_of(turned_drive, ring_of_corridors(), {}, T_turned_first, false);
  first.finish(drive.keyframes);
  turned.finish(turned_drive.keyframes);
  expect_meets_itself(first, drive);
  for (std::size_t i = 0; i < first.submaps().size(); ++i)
    EXPECT_THAT(turned.T_map_anchor(i), PoseNear(T_turned_first * first.T_map_anchor(i), 1e-6, 1e-6)) << i;
}

TEST(LoopCloser, ClosesNoLoopWhereThereIsNone) {
  TrackedDrive drive = drive_past({{0, 0}, {30, 0}, {30, 20}, {50, 20}});
  add_slip(0.01, -0.012, drive);
  Random random(5);
  std::vector<Segment2> walls;
  for (int i = 0; i < 300; ++i) {
    const Vec2 start{random.uniform(-4, 54), random.uniform(-4, 24)};
    const double heading_rad = static_cast<double>(random.index(4)) * kPi / 2;
    walls.push_back({start, start + random.uniform(0.5, 3) * unit(heading_rad)});
  }
  LoopCloser closer = closer_of(drive, walls);
  EXPECT_THAT(closer.closures(), IsEmpty());
  expect_as_tracked(closer);
  closer.finish(drive.keyframes);
  EXPECT_THAT(closer.closures(), IsEmpty());
  expect_as_tracked(closer);
}

/// The track comes back to where it began, but the vehicle has come to another place.
TEST(LoopCloser, DoesNotTakeAnotherPlaceForTheOldOne) {
  TrackedDrive drive = drive_past({{0, 0}, {30, 0}, {60, 0}});
  const TrackedDrive around =
      drive_past({{8, 1}, {15, 1}, {15, 9}, {1, 9}, {1, 1}, {15, 1}, {15, 3}, {15, 4}});
  for (std::size_t k = 0; k < std::min(drive.keyframes.size(), around.keyframes.size()); ++k)
    drive.keyframes[k].T_track_sensor = around.keyframes[k].T_track_sensor;
  drive.keyframes.resize(around.keyframes.size());
  for (std::size_t k = 0; k < drive.keyframes.size(); ++k)  // in the heading of the track
    drive.T_map_sensor[k].theta = drive.keyframes[k].T_track_sensor.theta;
  Random random(11);
  std::vector<Segment2> walls;
  for (int i = 0; i < 160; ++i) {
    const Vec2 start{random.uniform(-4, 64), random.uniform(-3, 3)};
    const double heading_rad = static_cast<double>(random.index(4)) * kPi / 2;
    walls.push_back({start, start + random.uniform(0.5, 3) * unit(heading_rad)});
  }
  LoopCloser closer = closer_of(drive, walls);
  closer.finish(drive.keyframes);
  EXPECT_THAT(closer.closures(), IsEmpty());
  expect_as_tracked(closer);
  EXPECT_THAT(closer_of(around, ring_of_corridors()).closures(), Not(IsEmpty())) << "the same track";
}

TEST(LoopCloser, AlongABareCorridorOnlyTheDriftAcrossIsCorrected) {
  TrackedDrive drive = drive_there_and_back();
  add_slip(0.006, 0, drive);
  for (Keyframe& keyframe : drive.keyframes) keyframe.T_track_sensor.y = 0.004 * keyframe.path_m;
  LoopCloser closer = closer_of(drive, corridor_with({}));
  EXPECT_THAT(closer.closures(), Not(IsEmpty()));
  closer.finish(drive.keyframes);
  const std::size_t last = closer.submaps().size() - 1;
  const Pose2 truth = true_anchor(closer, drive, last), tracked = closer.submaps()[last].T_track_anchor;
  EXPECT_GT(tracked.y - truth.y, 0.15);
  EXPECT_NEAR(closer.T_map_anchor(last).y, truth.y, 0.02);
  EXPECT_GT(tracked.x - truth.x, 0.2);
  EXPECT_NEAR(closer.T_map_anchor(last).x, tracked.x, 0.02);
}

TEST(LoopCloser, InALargeSearchABareCorridorSaysNothing) {
  const TrackedDrive drive = drive_there_and_back();
  LoopCloser closer = closer_of(drive, corridor_with({}), {.reach_floor_m = 0.9});
  closer.finish(drive.keyframes);
  EXPECT_THAT(closer.closures(), IsEmpty());
}

TEST(LoopCloser, RefusesPlacesThatLookAlikeWithinReach) {
  std::vector<double> every_metre;
  for (int x = -5; x < 35; ++x) every_metre.push_back(x + 0.3);
  const TrackedDrive drive = drive_there_and_back();
  EXPECT_THAT(closer_of(drive, corridor_with(every_metre), {.reach_floor_m = 1.5}).closures(), IsEmpty());
  EXPECT_THAT(closer_of(drive, corridor_with(every_metre), {.reach_floor_m = 0.1}).closures(),
              Not(IsEmpty()));
}

TEST(LoopCloser, ASubmapIsClosedOnceWithEachPlace) {
  TrackedDrive drive = drive_around();
  add_slip(0.01, -0.012, drive);
  for (const double reach_floor_m : {LoopParams{}.reach_floor_m, 1.2}) {
    LoopCloser closer = closer_of(drive, ring_of_corridors(), {.reach_floor_m = reach_floor_m});
    closer.finish(drive.keyframes);
    const std::vector<LoopClosure> closures = closer.closures();
    EXPECT_THAT(closures, Not(IsEmpty()));
    for (const LoopClosure& a : closures) {
      EXPECT_GT(closer.submaps()[a.newer].path_m - closer.submaps()[a.older].path_m, 12 - 1e-9);
      EXPECT_EQ(std::count_if(closures.begin(), closures.end(),
                              [&](const LoopClosure& b) {
                                return b.newer == a.newer && b.older < a.older + 3 && a.older < b.older + 3;
                              }),
                1)
          << a.older << " " << a.newer << " reach " << reach_floor_m;
    }
  }
}

TEST(LoopCloser, AfterALargeSearchASecondSubmapMustAgree) {
  TrackedDrive drive = drive_around();
  add_slip(0.01, -0.012, drive);
  LoopCloser closer({.reach_floor_m = 1.2}, MotionNoise{});
  std::vector<std::size_t> closures;
  for (std::size_t first = 0; first + kKeyframesPerSubmap <= drive.keyframes.size();
       first += kKeyframesPerSubmap) {
    closer.add(submap_seen(drive, first, ring_of_corridors(), {}, true), drive.keyframes, true);
    closures.push_back(closer.closures().size());
  }
  const auto some = std::find_if(closures.begin(), closures.end(), [](std::size_t n) { return n > 0; });
  ASSERT_NE(some, closures.end());
  EXPECT_GE(*some, 2U) << "the first is closed with the one that confirms it";
  EXPECT_NE(closer.closures()[0].newer, closer.closures()[*some - 1].newer);
  closer.finish(drive.keyframes);
  expect_meets_itself(closer, drive);
}

TEST(LoopCloser, RestatedOdometryScalesTheDriveAndCanBeTakenBack) {
  TrackedDrive drive = drive_past({{0, 0}, {12, 0}, {12, 16}, {30, 16}});
  for (Keyframe& keyframe : drive.keyframes) {
    keyframe.path.by_factor = keyframe.T_track_sensor.position();
    keyframe.path.counted_m = keyframe.path.by_factor;  // with the factor 1
  }
  LoopCloser closer = closer_of(drive, {});
  closer.restate_odometry(1.02, drive.keyframes);
  EXPECT_EQ(closer.odometry_factor(), 1.02);
  const Vec2 first = closer.T_map_anchor(0).position();
  for (std::size_t i = 0; i < closer.submaps().size(); ++i) {
    const Vec2 counted = closer.submaps()[i].T_track_anchor.position() - first;
    EXPECT_THAT(closer.T_map_anchor(i).position(), PointNear(Vec2(first + 1.02 * counted), 1e-6)) << i;
  }
  closer.restate_odometry(1, drive.keyframes);
  for (std::size_t i = 0; i < closer.submaps().size(); ++i)
    EXPECT_THAT(closer.T_map_anchor(i), PoseNear(closer.submaps()[i].T_track_anchor, 1e-6, 1e-6)) << i;
}

}  // namespace
}  // namespace aisle
