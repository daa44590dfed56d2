#include "aisle/guidance/rooms/odometry_calibration.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/geometry/segment2.hpp"

namespace aisle {
namespace {

constexpr double kCalibrationCycle_s = 0.1, kCalibrationSpeed_mps = 0.3;
constexpr double kSeenFrom_m = 1.35, kSeenTo_m = 4;  // ahead of base_link, in the middle of the image

using Walls = std::vector<Segment2>;

void add_box(const Vec2& low, const Vec2& high, Walls& walls) {
  const Vec2 right(high.x(), low.y()), left(low.x(), high.y());
  for (const Segment2& side : {Segment2{low, right}, {right, high}, {high, left}, {left, low}})
    walls.push_back(side);
}

/// 7 m x 2.4 m, with boxes along its walls.
Walls furnished_room() {
  Walls walls;
  add_box({-1, -1.2}, {6, 1.2}, walls);
  add_box({0.3, -1.2}, {0.9, -0.6}, walls);
  add_box({1.5, 0.7}, {2.1, 1.2}, walls);
  add_box({2.4, -1.2}, {3.1, -0.7}, walls);
  add_box({3.3, 0.6}, {3.9, 1.2}, walls);
  add_box({4.3, -1.2}, {4.9, -0.6}, walls);
  return walls;
}

Walls corridor() {
  return {{{-100, -1}, {100, -1}}, {{-100, 1}, {100, 1}}};
}

/// A vehicle whose wheels misreport, and its camera.
class DrivenFloor {
 public:
  explicit DrivenFloor(Walls walls) : walls_(std::move(walls)) {}

  /// One cycle with the front wheels at an angle.
  void step(double steering_rad, const OdometryCorrection& error, double speed_mps = kCalibrationSpeed_mps) {
    stamp_s_ += kCalibrationCycle_s;
    const FrontSteeredMotion real{speed_mps * kCalibrationCycle_s, steering_rad};
    T_world_vehicle_ = T_world_vehicle_ * drive(vehicle_, real);
    calibration_.move(stamp_s_,
                      {real.distance_m / error.distance_factor, steering_rad - error.steering_bias_rad},
                      real.distance_m);
    calibration_.look(stamp_s_, edges());
  }

  /// To and fro through the room for a time.
  void wander(double time_s, const OdometryCorrection& error) {
    for (double until_s = stamp_s_ + time_s; stamp_s_ < until_s;)
      step(0.2 * std::cos(stamp_s_ / 2), error,
           kCalibrationSpeed_mps * (std::fmod(stamp_s_, 24) < 12 ? 1 : -1));
  }

  /// What else may stand or walk there; seen from base_link.
  std::function<std::vector<Vec2>(double stamp_s)> p_vehicle_others = [](double) {
    return std::vector<Vec2>();
  };

  double stamp_s() const { return stamp_s_; }
  const OdometryCalibration& calibration() const { return calibration_; }

 private:
  /// Nearest wall points on rays of the camera, with a centimetre's noise.
  std::vector<Vec2> edges() {
    constexpr int kRays = 80;
    constexpr double kHalfView = 0.6, kNoise_m = 0.01;
    std::vector<Vec2> p_vehicle;
    for (int i = 0; i < kRays; ++i) {
      const double across = kHalfView * (1 - 2.0 * i / (kRays - 1));
      std::optional<double> ahead_m;
      for (const Segment2& wall : walls_) {
        const Pose2 T_vehicle_world = T_world_vehicle_.inverse();
        const Vec2 a = T_vehicle_world * wall.start, b = T_vehicle_world * wall.end;
        const double off_a = a.y() - across * a.x(), off_b = b.y() - across * b.x();
        if (off_a * off_b > 0 || off_a == off_b) continue;
        const double x = a.x() + off_a / (off_a - off_b) * (b.x() - a.x());
        if (x > 0 && (!ahead_m || x < *ahead_m)) ahead_m = x;
      }
      if (!ahead_m || *ahead_m < kSeenFrom_m || *ahead_m > kSeenTo_m) continue;
      const double seen_m = *ahead_m + random_.normal(kNoise_m);
      p_vehicle.emplace_back(seen_m, across * seen_m);
    }
    for (const Vec2& p : p_vehicle_others(stamp_s_)) p_vehicle.push_back(p);
    return p_vehicle;
  }

  Walls walls_;
  FrontSteered vehicle_;
  Pose2 T_world_vehicle_;
  double stamp_s_ = 0;
  Random random_{1};
  OdometryCalibration calibration_{vehicle_};
};

TEST(OdometryCalibration, FindsNothingWhereTheWheelsAreRight) {
  DrivenFloor floor(furnished_room());
  floor.wander(240, {});
  EXPECT_FALSE(floor.calibration().has_correction());
  EXPECT_EQ(floor.calibration().correction(), OdometryCorrection{});
}

TEST(OdometryCalibration, LeavesAPercentOfErrorToWhoLocalises) {
  DrivenFloor floor(furnished_room());
  floor.wander(120, {.distance_factor = 1.01, .steering_bias_rad = 0.3 * kDegree});
  EXPECT_FALSE(floor.calibration().has_correction());
}

/// Whatever the wheels begin to misreport, some metres later it is known; what they reported before the last
/// image that was still right is left alone.
RC_GTEST_PROP(OdometryCalibration, FindsWhatTheWheelsMisreport, ()) {
  const double factor = *rc::gen::inRange(50, 201) / 100.0;
  const double bias_rad = *rc::gen::inRange(-80, 81) / 10.0 * kDegree;
  RC_PRE(std::abs(std::log(factor)) > 0.2 || std::abs(bias_rad) > 3 * kDegree);
  const OdometryCorrection error{factor, bias_rad};
  DrivenFloor floor(furnished_room());
  const double before_s = *rc::gen::inRange(3, 10);
  floor.wander(before_s, {});
  const double begun_s = floor.stamp_s();
  while (!floor.calibration().has_correction() && floor.stamp_s() < begun_s + 20)
    floor.wander(kCalibrationCycle_s, error);
  RC_ASSERT(floor.calibration().has_correction());
  RC_ASSERT(floor.calibration().correction_from_s() > begun_s - 1.5);
  floor.wander(10, error);
  RC_ASSERT(std::abs(floor.calibration().correction().distance_factor / factor - 1) < 0.15);
  RC_ASSERT(std::abs(floor.calibration().correction().steering_bias_rad - bias_rad) <
            1.5 * kDegree + 0.3 * std::abs(bias_rad));
}

TEST(OdometryCalibration, GoesBackWhenTheWheelsAreRightAgain) {
  DrivenFloor floor(furnished_room());
  floor.wander(6, {});
  floor.wander(8, {.distance_factor = 0.5});
  EXPECT_NEAR(floor.calibration().correction().distance_factor, 0.5, 0.04);
  floor.wander(12, {});
  EXPECT_NEAR(floor.calibration().correction().distance_factor, 1, 0.04);
}

TEST(OdometryCalibration, LearnsOnlyTheSteeringBetweenStraightWalls) {
  DrivenFloor floor(corridor());
  for (int i = 0; i < 300; ++i) floor.step(0, {.distance_factor = 0.7});
  EXPECT_FALSE(floor.calibration().has_correction()) << "nothing shows the distance";
  for (int i = 0; i < 80; ++i) floor.step(0.02 * std::cos(i / 4.0), {.steering_bias_rad = 5 * kDegree});
  EXPECT_NEAR(to_degrees(floor.calibration().correction().steering_bias_rad), 5, 0.7);
}

TEST(OdometryCalibration, IsNotMisledBySomebodyWhoCrossesThePath) {
  DrivenFloor floor(furnished_room());
  floor.p_vehicle_others = [](double stamp_s) {
    constexpr double kEvery_s = 8, kWalk_mps = 0.8;
    std::vector<Vec2> legs;
    const double left_m = kWalk_mps * (std::fmod(stamp_s, kEvery_s) - kEvery_s / 2);
    if (std::abs(left_m) > 1) return legs;
    for (int i = 0; i < 12; ++i) legs.emplace_back(2, left_m - 0.03 * i);
    return legs;
  };
  floor.wander(120, {});
  EXPECT_FALSE(floor.calibration().has_correction());
}

TEST(OdometryCalibration, WheelsThatSpinOnTheSpotAreNoLongerPlausible) {
  DrivenFloor floor(furnished_room());
  floor.wander(5, {});
  EXPECT_TRUE(floor.calibration().is_plausible());
  for (int i = 0; i < 60; ++i) floor.step(0, {.distance_factor = 0.02}, 0.02 * kCalibrationSpeed_mps);
  EXPECT_FALSE(floor.calibration().is_plausible());
}

TEST(OdometryCalibration, BearsImagesWithoutEdges) {
  DrivenFloor floor({});
  floor.wander(30, {.distance_factor = 0.5});
  EXPECT_FALSE(floor.calibration().has_correction());
}

}  // namespace
}  // namespace aisle
