#include "aisle/learning/walls/scan_odometry.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "aisle/geometry/pose_change.hpp"

namespace aisle {
namespace {

constexpr double kLearned_m = 0.1;  // the map is extended after this much motion
constexpr double kLearned_rad = 5 * kDegree;
constexpr double kNearest_m = 0.05;         // nearer readings are the vehicle itself
constexpr double kVehicleSpeedMax_mps = 3;  // of vehicles in buildings
constexpr double kVehicleTurnMax_radps = 4;
constexpr double kAcceleration_mps2 = 2;  // by which the speed may change from scan to scan
constexpr double kTurning_radps2 = 6;
constexpr double kSpeedFloor_m = 0.02;
constexpr double kSpeedFloor_rad = 0.02;
constexpr double kCoast_s = 0.5;       // the last speed is carried on for at most this long
constexpr double kWellFitting = 0.75;  // with less on known surfaces, the motion is searched for
constexpr double kFitGain = 0.05;      // by which a fit from elsewhere must be better
constexpr double kStrangeShare = 0.5;  // a scan with less on known surfaces says nothing ...
constexpr double kTrustedShare = 0.8;  // ... one with more says what its points say
constexpr int kStrangeScans = 4;       // so many scans in a row that do not fit are new surroundings
constexpr double kAlikePoints = 10;    // so many neighbouring points share their errors
constexpr double kByChance = 0.03;     // information along a bare corridor, of that across: by noisy normals
constexpr double kNothing = 1e-6;      // information where there is none
constexpr double kUsual = 3;           // standard deviations: wheels that are off by more are wrong ...
constexpr double kRemembered = 0.7;    // ... and this share of it is remembered at the next scan

/// A matrix about (x, y, theta) in axes turned by this angle.
Mat3 turned(const Mat3& matrix, double angle_rad) {
  Mat3 turn = Mat3::Identity();
  turn.topLeftCorner<2, 2>() = rotation(angle_rad);
  return turn * matrix * turn.transpose();
}

/// What the points of a scan really know: less than if they were independent, and nothing along a bare
/// corridor.
Mat3 known_by(Mat3 information) {
  if (information(2, 2) <= 0) return Mat3::Zero();
  const Mat2 of_position = information.topLeftCorner<2, 2>() -
                           information.block<2, 1>(0, 2) * information.block<1, 2>(2, 0) / information(2, 2);
  const Eigen::SelfAdjointEigenSolver<Mat2> axes(of_position);
  const Vec2 least = axes.eigenvectors().col(0);
  const double by_chance = std::clamp(axes.eigenvalues()(0), 0.0, kByChance * axes.eigenvalues()(1));
  information.topLeftCorner<2, 2>() -= by_chance * least * least.transpose();
  return information / kAlikePoints;
}

/// How far the points of a scan are believed where there are wheels, too.
double trust_in_fit(double share) {
  return std::clamp((share - kStrangeShare) / (kTrustedShare - kStrangeShare), 0.0, 1.0);
}

}  // namespace

ScanMotion ScanOdometry::step(std::span<const Vec2> points, double time_s,
                              const std::optional<UncertainPose2>& counted) {
  surface_points(points, surface_);
  if (!last_s_) {
    last_s_ = time_s;
    learn();
    return {.T_last_now = counted.value_or(UncertainPose2{})};
  }
  const double step_s = time_s - *last_s_;
  const UncertainPose2 steady = coasted(step_s);
  const Pose2& expected = counted ? counted->mean : steady.mean;
  const SurfaceFit found = fit(expected, steady.mean, step_s);
  ScanMotion motion{.share = found.share, .information = turned(found.information, -T_map_laser_.theta)};

  const Vec3 off = change_between(expected, between(T_map_laser_, found.T_map_sensor));
  const Mat3 by_points = (counted ? trust_in_fit(found.share) : 1.0) * known_by(motion.information);
  const Mat3 by_speed = steady.covariance.inverse();
  Mat3 information = by_points + by_speed;
  if (counted) {
    const Mat3 points_covariance = (by_points + kNothing * Mat3::Identity()).inverse();
    doubt(off, (points_covariance + counted->covariance).diagonal());
    information += (counted->covariance + Mat3(wheel_variance_.asDiagonal())).inverse();
  }
  const Vec3 pull = by_points * off + by_speed * change_between(expected, steady.mean);
  const Mat3 covariance = information.inverse();
  const Pose2 moved = moved_by(expected, covariance * pull);
  motion.T_last_now = {moved, covariance};

  T_map_laser_ = T_map_laser_ * moved;
  velocity_ = step_s > 1e-6 ? Vec3(change_between({}, moved) / step_s) : Vec3::Zero();
  last_s_ = time_s;
  // Late wheels place a scan wrongly and catch up with the next one: what does not fit is learned only if
  // the scans after it do not fit either.
  strange_ = counted && found.share < kStrangeShare ? strange_ + 1 : 0;
  if (strange_ == 0 || strange_ >= kStrangeScans) learn();
  return motion;
}

/// The motion if the last speed goes on.
UncertainPose2 ScanOdometry::coasted(double step_s) const {
  const double time_s = std::max(0.0, step_s);
  const double sigma_m = kSpeedFloor_m + kAcceleration_mps2 * square(time_s);
  const double sigma_rad = kSpeedFloor_rad + kTurning_radps2 * square(time_s);
  return about(moved_by({}, std::min(time_s, kCoast_s) * velocity_), sigma_m, sigma_rad);
}

/// Fits the scan from where it is expected; if that does not fit well, also from where the last speed leads,
/// and from all around.
SurfaceFit ScanOdometry::fit(const Pose2& T_last_expected, const Pose2& T_last_coasted, double step_s) const {
  SurfaceFit best = fit_surface(surface_, map_, T_map_laser_ * T_last_expected, Mat3::Zero());
  const auto take_if_better = [&](const SurfaceFit& other) {
    if (other.share > best.share + kFitGain) best = other;
  };
  if (best.share < kWellFitting)
    take_if_better(fit_surface(surface_, map_, T_map_laser_ * T_last_coasted, Mat3::Zero()));
  if (best.share < kWellFitting) {
    const SearchReach reach{
        .position_m = std::clamp(kVehicleSpeedMax_mps * step_s, 0.2, 1.0),
        .heading_rad = std::clamp(kVehicleTurnMax_radps * step_s, 10 * kDegree, 60 * kDegree)};
    take_if_better(fit_surface_far(surface_, map_, T_map_laser_, reach));
  }
  return best;
}

/// How wrong the wheels are beyond their noise: the mean over the last scans of how far they were off, where
/// that is more than usual.
void ScanOdometry::doubt(const Vec3& off, const Vec3& expected_variance) {
  const Vec3 unusual = (off.cwiseAbs2() - square(kUsual) * expected_variance).cwiseMax(0);
  wheel_variance_ = kRemembered * wheel_variance_ + (1 - kRemembered) * unusual;
}

void ScanOdometry::learn() {
  const Pose2 moved = between(T_map_learned_, T_map_laser_);
  if (!map_.empty() && moved.position().norm() < kLearned_m && std::abs(moved.theta) < kLearned_rad) return;
  map_.add(surface_, T_map_laser_);
  T_map_learned_ = T_map_laser_;
}

void points_of(const LaserScanner& laser, std::span<const float> ranges_m, std::vector<Vec2>& points,
               const Pose2& swept) {
  points.clear();
  const double limit_m = std::min(kScanMatchingReach_m, laser.range_max_m);
  const double last = std::max(1.0, static_cast<double>(ranges_m.size()) - 1);
  for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
    const double range_m = ranges_m[beam];
    if (!(range_m > kNearest_m && range_m < limit_m)) continue;
    const double share = static_cast<double>(beam) / last - 0.5;
    points.push_back(range_m * unit(laser.beam_angle(beam) + share * swept.theta) + share * swept.position());
  }
}

}  // namespace aisle
