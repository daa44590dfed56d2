#include <gmock/gmock.h>

#include "aisle/guidance/obstacles/obstacle_guard.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// A vehicle with a scanner only; its scan is one beam straight ahead from base_link.
VehicleDescription scanner_cart() {
  VehicleDescription vehicle;
  vehicle.footprint = {.front_m = 1, .rear_m = 0.2, .width_m = 0.6, .height_m = 1};
  vehicle.limits.speed_max_mps = 1;
  vehicle.limits.deceleration_max_mps2 = 1;
  vehicle.scanner = LaserScanner{0, 1, 30, {}};
  return vehicle;
}

Observation scanned(double stamp_s, double range_m) {
  return {.stamp_s = stamp_s,
          .odometry = FrontSteeredMotion{},
          .scan = RangeScan{stamp_s, {static_cast<float>(range_m)}}};
}

/// Straight on.
PathAhead straight() {
  const Path path({{Pose2{}, {10, 0}}});
  return path_ahead(path, path.at(0), {}, ObstacleGuardParams{}.reach_m);
}

const Command kAhead{.speed_mps = 0.8};

Guarded guarded(ObstacleGuard& guard, const Observation& observation, const Command& requested = kAhead) {
  guard.look(observation);
  return guard.allow(requested, straight());
}

TEST(ObstacleGuard, LeavesTheCommandAloneWhereNothingStands) {
  ObstacleGuard guard(scanner_cart(), {}, nullptr);
  const Guarded free = guarded(guard, scanned(0.1, 30));
  EXPECT_EQ(free.command, kAhead);
  EXPECT_EQ(free.state, GuardState::kFree);
  EXPECT_EQ(free.why, "");
}

TEST(ObstacleGuard, KeepsTheVehiclesLimitsAndDrivesNoFasterThanItCanSee) {
  ObstacleGuard guard(scanner_cart(), {.reach_m = 1.5}, nullptr);
  const Guarded free = guarded(guard, scanned(0.1, 30), {.speed_mps = 9, .steering_rad = -9});
  EXPECT_LT(free.command.speed_mps, 0.8);
  EXPECT_EQ(free.command.steering_rad, -scanner_cart().limits.steering_max_rad);
}

TEST(ObstacleGuard, StopsAtTheGapHoweverTheVehicleBrakes) {
  const ObstacleGuardParams params;
  ObstacleGuard guard(scanner_cart(), params, nullptr);
  double range_m = 6, speed_mps = 1, before_mps = 1;
  for (double stamp_s = 0.1; stamp_s < 20; stamp_s += 0.1) {
    const double reported_mps = guarded(guard, scanned(stamp_s, range_m)).command.speed_mps;
    speed_mps = std::clamp(before_mps, speed_mps - 0.1, speed_mps + 0.05);  // a cycle late
    before_mps = reported_mps;
    range_m -= 0.1 * speed_mps;
  }
  EXPECT_EQ(speed_mps, 0);
  EXPECT_NEAR(range_m - 1, params.gap_m, 0.1);
}

TEST(ObstacleGuard, StopsWhereTheFloorEndsOnThePathOnceTwoImagesShowIt) {
  VehicleDescription blind = scanner_cart();
  blind.scanner.reset();
  const auto wall_at = [](double ahead_m, double right_m, double left_m) {
    SensedSegment edge;
    edge.segment = {{ahead_m, -right_m}, {ahead_m, left_m}};
    return edge;
  };
  ObstacleGuard guard(blind, {}, nullptr);
  auto speed_mps = [&, stamp_s = 0.0](const SensedSegment& edge) mutable {
    guard.look({.stamp_s = stamp_s += 0.1, .odometry = FrontSteeredMotion{}});
    guard.see_floor({&edge, 1}, stamp_s);
    return guard.allow(kAhead, straight()).command.speed_mps;
  };
  EXPECT_EQ(speed_mps(wall_at(1.5, 1, 1)), 0.8);
  EXPECT_EQ(speed_mps(wall_at(1.5, 1, 1)), 0);
  EXPECT_EQ(speed_mps(wall_at(1.5, -0.5, 1)), 0);  // the first free image is not trusted
}

TEST(ObstacleGuard, WaitsThenGoesOnOnceFreeForAMomentOrReportsABlockedPath) {
  ObstacleGuard guard(scanner_cart(), {.free_again_s = 0.5, .wait_max_s = 10}, nullptr);
  const Guarded waiting = guarded(guard, scanned(1, 1.4));
  EXPECT_EQ(waiting.state, GuardState::kWaiting);
  EXPECT_EQ(waiting.command.speed_mps, 0);
  EXPECT_THAT(waiting.why, HasSubstr("obstacle ahead, 0.4 m away"));
  EXPECT_EQ(guarded(guard, scanned(10.9, 1.4)).state, GuardState::kWaiting);
  EXPECT_EQ(guarded(guard, scanned(11.1, 1.4)).state, GuardState::kBlocked);
  EXPECT_EQ(guarded(guard, scanned(11.2, 30)).command.speed_mps, 0);
  EXPECT_EQ(guarded(guard, scanned(11.7, 30)).command, kAhead);
}

TEST(ObstacleGuard, ReversesSlowlyAwayFromWhatIsAhead) {
  ObstacleGuard guard(scanner_cart(), {.reverse_speed_mps = 0.15}, nullptr);
  EXPECT_EQ(guarded(guard, scanned(0.1, 1.1), {.speed_mps = -0.4}).command.speed_mps, -0.15);
}

/// A vehicle with laser markers and a camera.
VehicleDescription marker_cart() {
  VehicleDescription vehicle = scanner_cart();
  vehicle.scanner.reset();
  vehicle.cameras = {{.name = "front", .mount = {{0.8, 0, 1}, 0.25, 0, 0}}};
  vehicle.laser_markers.emplace();
  return vehicle;
}

Observation shown(double stamp_s, double taken_s, int level) {
  auto image = std::make_shared<Image>(640, 480);
  std::fill(image->bytes.begin(), image->bytes.end(), static_cast<std::uint8_t>(level));
  image->bytes[0] = static_cast<std::uint8_t>(std::lround(10 * taken_s));  // no two images are the same
  return {.stamp_s = stamp_s, .images = {{"front", taken_s, image}}, .odometry = FrontSteeredMotion{}};
}

/// The same with laser light across the whole image, on an obstacle at a distance ahead of base_link.
Observation lit(double stamp_s, double ahead_m) {
  Observation observation = shown(stamp_s, stamp_s, 120);
  Image image = *observation.images[0].pixels;
  const CameraDescription camera = marker_cart().cameras[0];
  const Vec3 p_camera = camera.mount.to_camera({ahead_m, 0, marker_cart().laser_markers->height_m});
  const int row = static_cast<int>(std::lround(CameraModel(camera.intrinsics).project(p_camera)->y()));
  std::fill(image.row(row), image.row(row + 1), static_cast<std::uint8_t>(220));
  observation.images[0].pixels = std::make_shared<Image>(image);
  return observation;
}

TEST(ObstacleGuard, StopsForLaserLightInItsPathOnceItHasBeenSeenTwice) {
  const VehicleDescription vehicle = marker_cart();
  ObstacleGuard guard(vehicle, {}, &vehicle.cameras[0]);
  EXPECT_EQ(guarded(guard, shown(0.1, 0.1, 120)).command, kAhead);
  EXPECT_EQ(guarded(guard, lit(0.2, 1.75)).state, GuardState::kFree);
  const Guarded waiting = guarded(guard, lit(0.3, 1.75));
  EXPECT_EQ(waiting.state, GuardState::kWaiting);
  EXPECT_NEAR(waiting.free_ahead_m, 0.7, 0.06);
}

TEST(ObstacleGuard, RemembersAnObstacleThatIsTooNearToBeSeen) {
  const VehicleDescription vehicle = marker_cart();
  const ObstacleGuardParams params;
  ObstacleGuard guard(vehicle, params, &vehicle.cameras[0]);
  for (double stamp_s : {0.1, 0.2, 0.3}) guarded(guard, lit(stamp_s, 2));
  Observation moved = shown(0.4, 0.4, 120);
  moved.odometry = FrontSteeredMotion{.distance_m = 0.6};  // 0.4 m before it
  EXPECT_EQ(guarded(guard, moved).state, GuardState::kWaiting);
  EXPECT_EQ(guarded(guard, shown(params.memory.kept_s, params.memory.kept_s, 120)).state,
            GuardState::kWaiting);
  double stamp_s = params.memory.kept_s + 0.5;
  guarded(guard, shown(stamp_s, stamp_s, 120));
  stamp_s += params.free_again_s;
  EXPECT_EQ(guarded(guard, shown(stamp_s, stamp_s, 120)).state, GuardState::kFree);
}

TEST(ObstacleGuard, GoesSlowlyWhereNoLaserLightIsInView) {
  const VehicleDescription vehicle = marker_cart();
  const ObstacleGuardParams params;
  ObstacleGuard guard(vehicle, params, &vehicle.cameras[0]);
  Guarded last;
  for (int i = 1; i <= 30; ++i) last = guarded(guard, shown(0.1 * i, 0.1 * i, 120));
  EXPECT_EQ(last.command.speed_mps, params.unlit_speed_mps);
  EXPECT_EQ(guarded(guard, lit(3.1, 8)).command, kAhead);
}

/// The guard's answer after a second of good images and another one of the given images.
template <class Bad>
std::string why_after(const Bad& bad) {
  VehicleDescription vehicle = marker_cart();
  vehicle.laser_markers.reset();
  ObstacleGuard guard(vehicle, {}, &vehicle.cameras[0]);
  for (int i = 0; i <= 10; ++i) guarded(guard, shown(0.1 * i, 0.1 * i, 120));
  EXPECT_EQ(guarded(guard, shown(1.1, 1.1, 120)).state, GuardState::kFree);
  Guarded last;
  for (int i = 12; i <= 20; ++i) last = guarded(guard, bad(0.1 * i));
  EXPECT_EQ(last.command.speed_mps, 0);
  EXPECT_EQ(last.state, GuardState::kWaiting);
  Guarded again;
  for (int i = 21; i <= 40; ++i) again = guarded(guard, shown(0.1 * i, 0.1 * i, 120));
  EXPECT_EQ(again.command, kAhead);
  return last.why;
}

TEST(ObstacleGuard, StopsAndSaysWhyWhenTheCameraFails) {
  const auto frozen = [](double now_s) {
    Observation observation = shown(now_s, 1.1, 120);
    observation.images[0].stamp_s = now_s;
    observation.odometry = FrontSteeredMotion{.distance_m = 0.03};
    return observation;
  };
  EXPECT_EQ(why_after(frozen), "camera front is frozen");
  EXPECT_EQ(why_after([](double now_s) { return shown(now_s, now_s, 0); }), "camera front sees no light");
  EXPECT_EQ(why_after([](double now_s) { return shown(now_s, now_s, 255); }), "camera front is dazzled");
  EXPECT_EQ(why_after([](double now_s) { return shown(now_s, now_s - 0.6, 120); }), "camera front is late");
  const auto silent = [](double now_s) {
    return Observation{.stamp_s = now_s, .odometry = FrontSteeredMotion{}};
  };
  EXPECT_EQ(why_after(silent), "camera front sends no images");
}

}  // namespace
}  // namespace aisle
