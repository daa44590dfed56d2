#include <gmock/gmock.h>

#include "aisle/guidance/obstacle_guard.hpp"
#include "aisle/guidance/swept_strip.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// Sees by its scanner alone; the scan is one beam straight ahead from base_link.
VehicleDescription scanner_cart() {
  VehicleDescription vehicle;
  vehicle.footprint = {.front_m = 1, .rear_m = 0.2, .width_m = 0.6, .height_m = 1};
  vehicle.limits.speed_max_mps = 1;
  vehicle.limits.deceleration_max_mps2 = 1;
  vehicle.scanner = LaserScanner{0, 1, 30, {}};
  return vehicle;
}

Observation seen(double stamp_s, double range_m) {
  return {.stamp_s = stamp_s,
          .odometry = FrontSteeredMotion{},
          .scan = RangeScan{stamp_s, {static_cast<float>(range_m)}}};
}

const Command kAhead{.speed_mps = 1};

TEST(ObstacleGuard, LeavesTheCommandAloneWhereNothingStands) {
  ObstacleGuard guard(scanner_cart(), {});
  const Guarded guarded = guard.guard(seen(0.1, 30), kAhead);
  EXPECT_EQ(guarded.command, kAhead);
  EXPECT_EQ(guarded.state, GuardState::kFree);
  EXPECT_EQ(guarded.why, "");
}

TEST(ObstacleGuard, HoldsTheVehiclesLimits) {
  ObstacleGuard guard(scanner_cart(), {});
  const Guarded guarded = guard.guard(seen(0.1, 30), {.speed_mps = 9, .steering_rad = -9});
  EXPECT_EQ(guarded.command.speed_mps, 1);
  EXPECT_EQ(guarded.command.steering_rad, -scanner_cart().limits.steering_max_rad);
}

TEST(ObstacleGuard, StopsAtTheGapHoweverTheVehicleBrakes) {
  const ObstacleGuardParams params;
  ObstacleGuard guard(scanner_cart(), params);
  double range_m = 6, speed_mps = 1, before_mps = 1;
  for (double stamp_s = 0.1; stamp_s < 20; stamp_s += 0.1) {
    const double told_mps = guard.guard(seen(stamp_s, range_m), kAhead).command.speed_mps;
    speed_mps = std::clamp(before_mps, speed_mps - 0.1, speed_mps + 0.05);  // a cycle late
    before_mps = told_mps;
    range_m -= 0.1 * speed_mps;
  }
  EXPECT_EQ(speed_mps, 0);
  EXPECT_NEAR(range_m - 1, params.gap_m, 0.1);
}

TEST(ObstacleGuard, WaitsGoesOnWhenItIsFreeForAMomentAndReportsAfterAWhile) {
  ObstacleGuard guard(scanner_cart(), {.free_again_s = 0.5, .wait_max_s = 10});
  const Guarded waiting = guard.guard(seen(1, 1.1), kAhead);
  EXPECT_EQ(waiting.state, GuardState::kWaiting);
  EXPECT_EQ(waiting.command.speed_mps, 0);
  EXPECT_THAT(waiting.why, HasSubstr("something stands 0.1 m ahead"));
  EXPECT_EQ(guard.guard(seen(10.9, 1.1), kAhead).state, GuardState::kWaiting);
  EXPECT_EQ(guard.guard(seen(11.1, 1.1), kAhead).state, GuardState::kBlocked);
  EXPECT_EQ(guard.guard(seen(11.2, 30), kAhead).command.speed_mps, 0);
  EXPECT_EQ(guard.guard(seen(11.7, 30), kAhead).command, kAhead);
}

TEST(ObstacleGuard, ReversesSlowlyAndGetsAwayFromWhatItTouches) {
  ObstacleGuard guard(scanner_cart(), {.reverse_speed_mps = 0.15});
  Observation touching = seen(0.1, 1);
  touching.bumper_pressed = true;
  EXPECT_EQ(guard.guard(touching, kAhead).state, GuardState::kBlocked);
  EXPECT_EQ(guard.guard(touching, kAhead).command.speed_mps, 0);
  EXPECT_EQ(guard.guard(touching, {.speed_mps = -0.4}).command.speed_mps, -0.15);
}

TEST(ObstacleGuard, AVehicleThatCannotSeeIsRefused) {
  VehicleDescription blind = scanner_cart();
  blind.scanner.reset();
  EXPECT_THROW(ObstacleGuard(blind, {}), std::invalid_argument);
  EXPECT_THROW(ObstacleGuard(scanner_cart(), {}, "front"), std::invalid_argument);
}

VehicleDescription camera_cart() {
  VehicleDescription vehicle = scanner_cart();
  vehicle.scanner.reset();
  vehicle.cameras = {{.name = "front", .mount = {{0.8, 0, 1}, 0.25, 0, 0}}};
  return vehicle;
}

Observation shown(double stamp_s, double taken_s, int level) {
  auto image = std::make_shared<Image>(640, 480);
  std::fill(image->bytes.begin(), image->bytes.end(), static_cast<std::uint8_t>(level));
  image->bytes[0] = static_cast<std::uint8_t>(std::lround(10 * taken_s));  // no two pictures are the same
  return {.stamp_s = stamp_s, .pictures = {{"front", taken_s, image}}, .odometry = FrontSteeredMotion{}};
}

/// What the guard says after a second of good pictures and another of the ones given.
template <class Bad>
Guarded after(const Bad& bad) {
  ObstacleGuard guard(camera_cart(), {});
  for (int i = 0; i <= 10; ++i) guard.guard(shown(0.1 * i, 0.1 * i, 120), kAhead);
  EXPECT_EQ(guard.guard(shown(1.1, 1.1, 120), kAhead).state, GuardState::kFree);
  Guarded last;
  for (int i = 12; i <= 20; ++i) last = guard.guard(bad(0.1 * i), kAhead);
  EXPECT_EQ(last.command.speed_mps, 0);
  EXPECT_EQ(last.state, GuardState::kWaiting);
  Guarded again;
  for (int i = 21; i <= 40; ++i) again = guard.guard(shown(0.1 * i, 0.1 * i, 120), kAhead);
  EXPECT_EQ(again.command, kAhead);
  return last;
}

TEST(ObstacleGuard, StopsForACameraThatShowsNothingNewAndSaysWhy) {
  EXPECT_EQ(after([](double now_s) {
              Observation frozen = shown(now_s, 1.1, 120);
              frozen.pictures[0].stamp_s = now_s;
              return frozen;
            }).why,
            "camera front is frozen");
  EXPECT_EQ(after([](double now_s) { return shown(now_s, now_s, 0); }).why, "camera front sees no light");
  EXPECT_EQ(after([](double now_s) { return shown(now_s, now_s, 255); }).why, "camera front is dazzled");
  EXPECT_EQ(after([](double now_s) { return shown(now_s, now_s - 0.6, 120); }).why, "camera front is late");
  EXPECT_EQ(
      after([](double now_s) { return Observation{.stamp_s = now_s, .odometry = FrontSteeredMotion{}}; }).why,
      "camera front sends no pictures");
}

TEST(SweptStrip, IsFreeUpToTheFirstPointOnTheArc) {
  SweptStrip strip{.footprint = scanner_cart().footprint, .margin_m = 0.1};
  const std::vector<Vec2> points{{3, 0.39}, {4, 0}, {2, 0.5}};
  EXPECT_NEAR(strip.free_m(points, 10), 2, 1e-9);
  EXPECT_EQ(strip.free_m({}, 10), 10);
  strip.turn_rad_per_m = -1;  // to the right, away from all of them
  EXPECT_EQ(strip.free_m(points, 1.5), 1.5);
  strip.turn_rad_per_m = 0.4;
  EXPECT_LT(strip.free_m(points, 10), 1.3);
}

}  // namespace
}  // namespace aisle
