#include "aisle/guidance/rooms/odometry_calibration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

// Images are compared that lie this far apart, by the wheels or, as these may count too little, by the
// command. Nearer ones show too little motion (tried: 0.15 m), farther ones too few of the same edges.
constexpr double kBaseline_m = 0.3;
constexpr double kLost_m = 1;  // after so much path without edges, it begins anew

constexpr double kReach_m = 3.5;        // from base_link: an image row covers more floor farther off
constexpr double kNeighbour_m = 0.2;    // edges this near to each other form a line
constexpr double kMatched_m = 0.4;      // from an edge to the one that it is compared with
constexpr std::size_t kLineReach = 4;   // edges on either side that tell its direction: they lie in steps
constexpr double kDeviation_m = 0.03;   // of an edge from its line; robust beyond
constexpr double kAccurate_m = 2.2;     // from base_link; beyond, it grows with the square
constexpr double kIndependent = 8;      // the edges of a line deviate alike: so many count
constexpr double kCostExpected = 0.27;  // of an edge; where they fit worse, they say less
constexpr double kRow_m = 0.005;  // ahead: edges no farther apart lie in one row of the image, and err alike
constexpr int kMatchesMin = 10;
constexpr int kIterations = 6;

// Standard deviations by which the error may change in a metre: of the agile and of the steady filter.
constexpr double kAgileFactor = 0.2, kAgileBias_rad = 3 * kDegree;
constexpr double kSteadyFactor = 0.02, kSteadyBias_rad = 0.3 * kDegree;
// The same after something has happened to the wheels, and what that costs: e^-3, once in some 20
// measurements.
constexpr double kBrokenFactor = 0.5, kBrokenBias_rad = 6 * kDegree, kBrokenCost = 3;
constexpr double kFactorsTried[] = {0.4, 0.55, 0.75, 1.0, 1.3, 1.7, 2.1};

constexpr double kSurelyOff = 13.8;  // chi-square of two degrees of freedom, 99.9 %
constexpr int kOffMin = 2;           // measurements in a row

constexpr double kFactorMin = 0.2, kFactorMax = 4, kBiasMax_rad = 20 * kDegree;
constexpr double kPlausibleFactorMin = 0.35, kPlausibleFactorMax = 2.8;  // beyond, they spin or are stuck

Vec2 as_vector(const OdometryCorrection& error) {
  return {error.distance_factor, error.steering_bias_rad};
}

OdometryCorrection moved(const OdometryCorrection& error, const Vec2& by) {
  return {std::clamp(error.distance_factor + by.x(), kFactorMin, kFactorMax),
          std::clamp(error.steering_bias_rad + by.y(), -kBiasMax_rad, kBiasMax_rad)};
}

Mat2 covariance(double factor, double bias_rad) {
  return Vec2(square(factor), square(bias_rad)).asDiagonal();
}

}  // namespace

OdometryCalibration::Estimate OdometryCalibration::fused(const Estimate& one, const Estimate& other) {
  const Mat2 information = one.covariance.inverse(), further = other.covariance.inverse();
  const Mat2 covariance = (information + further).inverse();
  const Vec2 mean = covariance * (information * as_vector(one.error) + further * as_vector(other.error));
  return {{mean.x(), mean.y()}, covariance};
}

bool OdometryCalibration::surely_differ(const Estimate& one, const Estimate& other) {
  const Vec2 off = as_vector(one.error) - as_vector(other.error);
  return off.dot((one.covariance + other.covariance).ldlt().solve(off)) > kSurelyOff;
}

void OdometryCalibration::move(double stamp_s, const FrontSteeredMotion& reported, double commanded_m) {
  if (!key_.empty()) motions_.push_back({stamp_s, reported, std::abs(commanded_m)});
}

void OdometryCalibration::look(double stamp_s, std::span<const Vec2> p_vehicle) {
  if (key_.empty()) return begin_at(stamp_s, p_vehicle);
  const double path_m = path_from_key_m(stamp_s);
  if (std::max(path_m, commanded_from_key_m(stamp_s)) < kBaseline_m) return;
  if (path_m < kLost_m) measure(path_m, stamp_s, p_vehicle);
  begin_at(stamp_s, p_vehicle);
}

bool OdometryCalibration::is_plausible() const {
  const double factor = correction().distance_factor;
  return factor > kPlausibleFactorMin && factor < kPlausibleFactorMax;
}

double OdometryCalibration::path_from_key_m(double stamp_s) const {
  double path_m = 0;
  for (const Motion& motion : motions_)
    if (motion.stamp_s <= stamp_s) path_m += std::abs(motion.reported.distance_m);
  return agile_.error.distance_factor * path_m;
}

double OdometryCalibration::commanded_from_key_m(double stamp_s) const {
  double path_m = 0;
  for (const Motion& motion : motions_)
    if (motion.stamp_s <= stamp_s) path_m += motion.commanded_m;
  return path_m;
}

Pose2 OdometryCalibration::T_key_vehicle(double stamp_s, const OdometryCorrection& error) const {
  Pose2 T;
  double before_s = key_s_;
  for (const Motion& motion : motions_) {
    if (before_s >= stamp_s) break;
    FrontSteeredMotion part = error.corrected(motion.reported);
    part.distance_m *= std::min(1.0, (stamp_s - before_s) / (motion.stamp_s - before_s));
    T = T * drive(vehicle_, part);
    before_s = motion.stamp_s;
  }
  return T;
}

void OdometryCalibration::begin_at(double stamp_s, std::span<const Vec2> p_vehicle) {
  key_s_ = stamp_s;
  std::erase_if(motions_, [&](const Motion& motion) { return motion.stamp_s <= stamp_s; });
  key_.clear();
  key_nearest_m_ = kReach_m;
  std::size_t connected = 0;  // edges up to the present one that form a line
  for (std::size_t end = 0; end < p_vehicle.size(); ++end) {
    const bool goes_on = end > 0 && (p_vehicle[end] - p_vehicle[end - 1]).norm() < kNeighbour_m;
    connected = goes_on ? connected + 1 : 1;
    if (connected <= 2 * kLineReach) continue;
    const std::size_t i = end - kLineReach;
    const Vec2 along = p_vehicle[end] - p_vehicle[i - kLineReach];
    if (along.isZero() || p_vehicle[i].norm() > kReach_m) continue;
    key_.push_back({p_vehicle[i], Vec2(-along.y(), along.x()).normalized()});
    key_nearest_m_ = std::min(key_nearest_m_, p_vehicle[i].norm());
  }
}

void OdometryCalibration::measure(double path_m, double stamp_s, std::span<const Vec2> p_vehicle) {
  const auto agile = follow(path_m, stamp_s, p_vehicle);
  if (!agile) return;
  const bool goes_on = !surely_differ(*agile, agile_);
  agile_ = *agile;
  if (steady_) {
    steady_->covariance += path_m * covariance(kSteadyFactor, kSteadyBias_rad);
    if (const auto steady = updated(*steady_, steady_->error, stamp_s, p_vehicle)) steady_ = steady;
  }
  correction_from_s_ = stamp_s;
  const bool is_off = surely_differ(agile_, {correction(), Mat2::Zero()});
  off_ = is_off ? (goes_on ? off_ + 1 : 1) : 0;
  if (off_ == 1) off_from_s_ = key_s_;
  if (off_ < kOffMin) return;
  steady_ = agile_;
  correction_from_s_ = off_from_s_;
}

/// The agile filter's next estimate: the wheels are as they were, or, if that explains the images better,
/// something has happened to them.
std::optional<OdometryCalibration::Estimate> OdometryCalibration::follow(double path_m, double stamp_s,
                                                                         std::span<const Vec2> p_vehicle) {
  const Estimate broken{correction(), covariance(kBrokenFactor, kBrokenBias_rad), kBrokenCost};
  // What nothing has shown for long is no better known than after a fault.
  const Estimate as_before =
      fused({agile_.error, agile_.covariance + path_m * covariance(kAgileFactor, kAgileBias_rad)}, broken);
  auto best = updated(as_before, as_before.error, stamp_s, p_vehicle);
  if (!best || best->cost < kBrokenCost) return best;
  for (const double factor : kFactorsTried) {
    const auto other = updated(broken, {.distance_factor = factor}, stamp_s, p_vehicle);
    if (other && other->cost < best->cost) best = other;
  }
  return best;
}

/// Iterated extended Kalman filter.
/// @param first  where it begins to iterate
/// @return nullopt: too few edges match
std::optional<OdometryCalibration::Estimate> OdometryCalibration::updated(
    const Estimate& prior, const OdometryCorrection& first, double stamp_s,
    std::span<const Vec2> p_vehicle) const {
  const Mat2 prior_information = prior.covariance.inverse();
  OdometryCorrection found = first;
  Agreement agreement = compared(stamp_s, p_vehicle, found);
  for (int i = 0; i < kIterations; ++i) {
    const Vec2 to_prior = as_vector(prior.error) - as_vector(found);
    found = moved(found, (prior_information + agreement.information)
                             .ldlt()
                             .solve(prior_information * to_prior - agreement.gradient));
    agreement = compared(stamp_s, p_vehicle, found);
  }
  if (agreement.matches < kMatchesMin) return std::nullopt;
  const Vec2 off = as_vector(found) - as_vector(prior.error);
  return Estimate{found, (prior_information + agreement.information).inverse(),
                  prior.cost + agreement.cost + off.dot(prior_information * off) / 2};
}

/// Each edge with the line through the nearest one of the key image.
OdometryCalibration::Agreement OdometryCalibration::compared(double stamp_s, std::span<const Vec2> p_vehicle,
                                                             const OdometryCorrection& error) const {
  constexpr double kFactorStep = 0.01, kBiasStep_rad = 0.01;  // numerical derivatives
  const Pose2 T = T_key_vehicle(stamp_s, error);
  const Pose2 T_factor =
      T_key_vehicle(stamp_s, {error.distance_factor + kFactorStep, error.steering_bias_rad});
  const Pose2 T_bias =
      T_key_vehicle(stamp_s, {error.distance_factor, error.steering_bias_rad + kBiasStep_rad});
  Agreement agreement;
  int unmatched = 0, rows = 0;
  double row_ahead_m = 0;
  for (const Vec2& p : p_vehicle) {
    if (p.norm() > kReach_m) continue;
    const Vec2 p_key = T * p;
    const auto nearest = std::min_element(key_.begin(), key_.end(), [&](const Edge& a, const Edge& b) {
      return (a.p_vehicle - p_key).squaredNorm() < (b.p_vehicle - p_key).squaredNorm();
    });
    if (nearest == key_.end() || (nearest->p_vehicle - p_key).norm() > kMatched_m) {
      const bool was_in_view = p_key.norm() > key_nearest_m_ && p_key.norm() < kReach_m - kMatched_m;
      unmatched += was_in_view ? 1 : 0;
      continue;
    }
    const Vec2& normal = nearest->normal;
    const double deviation_m =
        kDeviation_m * std::max(1.0, nearest->p_vehicle.squaredNorm() / square(kAccurate_m));
    const double off = normal.dot(p_key - nearest->p_vehicle) / deviation_m;
    const Vec2 jacobian =
        Vec2(normal.dot(T_factor * p - p_key) / kFactorStep, normal.dot(T_bias * p - p_key) / kBiasStep_rad) /
        deviation_m;
    const double weight = 1 / (1 + square(off));  // Cauchy
    agreement.cost += std::log1p(square(off)) / 2;
    agreement.gradient += weight * off * jacobian;
    agreement.information += weight * jacobian * jacobian.transpose();
    ++agreement.matches;
    if (std::abs(p.x() - std::exchange(row_ahead_m, p.x())) > kRow_m) ++rows;
  }
  agreement.cost += unmatched * std::log1p(square(kMatched_m / kDeviation_m)) / 2;
  const int edges = std::max(1, agreement.matches + unmatched);
  const double deviation = std::max(1.0, agreement.cost / (kCostExpected * edges));
  const double counting = std::min(1.0, std::min<double>(kIndependent, rows) / edges);
  agreement.cost *= counting;
  agreement.gradient *= counting / deviation;
  agreement.information *= counting / deviation;
  return agreement;
}

}  // namespace aisle
