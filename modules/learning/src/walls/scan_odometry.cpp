#include "aisle/learning/walls/scan_odometry.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kLearned_m = 0.1;  // the map is extended after this much motion
constexpr double kLearned_rad = 5 * kDegree;
constexpr double kNearest_m = 0.05;       // nearer readings are the vehicle itself
constexpr double kAcceleration_mps2 = 1;  // by which the speed may change from scan to scan
constexpr double kTurning_radps2 = 3;
constexpr double kSigmaFloor_m = 0.01;
constexpr double kSigmaFloor_rad = 0.01;
constexpr double kWellFitting = 0.75;  // with less on known surfaces, the pose is searched for
constexpr double kFarFitGain = 0.05;
constexpr double kCoast_s = 0.5;  // the last speed is carried on for at most this long

Mat3 information_after(double step_s) {
  const double time_s = std::clamp(step_s, 0.0, kCoast_s);
  const double sigma_m = kSigmaFloor_m + kAcceleration_mps2 * square(time_s);
  const double sigma_rad = kSigmaFloor_rad + kTurning_radps2 * square(time_s);
  return Vec3(1 / square(sigma_m), 1 / square(sigma_m), 1 / square(sigma_rad)).asDiagonal();
}

}  // namespace

ScanMotion ScanOdometry::step(std::span<const Vec2> points, double time_s) {
  surface_points(points, surface_);
  if (!last_s_) {
    last_s_ = time_s;
    learn();
    return {};
  }
  const double step_s = time_s - *last_s_;
  const Pose2 T_map_last = T_map_laser_;
  SurfaceFit fit = fit_surface(surface_, map_, predicted(time_s), information_after(step_s));
  if (fit.share < kWellFitting) {
    const SearchReach reach{
        .position_m = std::clamp(kVehicleSpeedMax_mps * step_s, 0.2, 1.0),
        .heading_rad = std::clamp(kVehicleTurnMax_radps * step_s, 10 * kDegree, 60 * kDegree)};
    const SurfaceFit far = fit_surface_far(surface_, map_, T_map_last, reach);
    if (far.share > fit.share + kFarFitGain) fit = far;
  }
  T_map_laser_ = fit.T_map_sensor;
  const Pose2 T_last_now = between(T_map_last, T_map_laser_);
  velocity_ =
      step_s > 1e-6 ? Vec3(Vec3(T_last_now.x, T_last_now.y, T_last_now.theta) / step_s) : Vec3::Zero();
  last_s_ = time_s;
  const Pose2 moved = between(T_map_learned_, T_map_laser_);
  if (moved.position().norm() > kLearned_m || std::abs(moved.theta) > kLearned_rad) learn();
  return {T_last_now, fit.share, fit.information};
}

double ScanOdometry::share_at(std::span<const Vec2> points, const Pose2& T_last_now) {
  surface_points(points, surface_);
  return fit_surface(surface_, map_, T_map_laser_ * T_last_now, Mat3::Zero()).share;
}

Pose2 ScanOdometry::predicted(double time_s) const {
  const Vec3 step = std::min(time_s - *last_s_, kCoast_s) * velocity_;
  return T_map_laser_ * Pose2{step.x(), step.y(), step.z()};
}

void ScanOdometry::learn() {
  map_.add(surface_, T_map_laser_);
  T_map_learned_ = T_map_laser_;
}

void points_of(const LaserScanner& laser, std::span<const float> ranges_m, std::vector<Vec2>& points) {
  points.clear();
  const double limit_m = std::min(kScanMatchingReach_m, laser.range_max_m);
  for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
    const double range_m = ranges_m[beam];
    if (range_m > kNearest_m && range_m < limit_m) points.push_back(range_m * unit(laser.beam_angle(beam)));
  }
}

}  // namespace aisle
