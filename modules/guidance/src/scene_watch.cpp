#include "aisle/guidance/scene_watch.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr std::size_t kComparedMin = 5;  // sightings, in either picture
constexpr double kGateSigmas = 3.5;
constexpr double kMovedSigma_m = 0.03;  // of what odometry says of the move between two pictures
constexpr double kOtherShareMax = 0.2;  // of the sightings known, in another scene
constexpr double kSameShareMin = 0.5;
constexpr double kComparedWay_m = 0.5;  // farther on, other things come into view by themselves ...
constexpr double kComparedTurn_rad = 10 * kDegree;  // ... and farther round

bool is_of_one_thing(const LandmarkSighting& a, const LandmarkSighting& b) {
  if (a.brighter_right != b.brighter_right) return false;
  const Mat2 covariance = a.covariance + b.covariance + square(kMovedSigma_m) * Mat2::Identity();
  const Vec2 off = a.p_vehicle - b.p_vehicle;
  return off.dot(covariance.inverse() * off) < square(kGateSigmas);
}

/// How much of a picture another one shows too.
double known_share(std::span<const LandmarkSighting> picture, std::span<const LandmarkSighting> other) {
  const auto known = std::count_if(picture.begin(), picture.end(), [&](const LandmarkSighting& seen) {
    return std::any_of(other.begin(), other.end(),
                       [&](const LandmarkSighting& before) { return is_of_one_thing(seen, before); });
  });
  return static_cast<double>(known) / static_cast<double>(picture.size());
}

void carry(std::vector<LandmarkSighting>& scene, const Pose2& T_now_before) {
  const Mat2 R_now_before = rotation(T_now_before.theta);
  for (LandmarkSighting& sighting : scene) {
    sighting.p_vehicle = T_now_before * sighting.p_vehicle;
    sighting.covariance = R_now_before * sighting.covariance * R_now_before.transpose();
  }
}

}  // namespace

void SceneWatch::move(const Pose2& T_before_now) {
  carry(known_, T_before_now.inverse());
  carry(other_, T_before_now.inverse());
  since_known_m_ += T_before_now.position().norm();
  since_known_rad_ += T_before_now.theta;
}

bool SceneWatch::look(std::span<const LandmarkSighting> picture, bool is_known_here) {
  if (picture.size() < kComparedMin) return false;
  const bool can_tell = known_.size() >= kComparedMin && since_known_m_ < kComparedWay_m &&
                        std::abs(since_known_rad_) < kComparedTurn_rad;
  const bool goes_on = is_known_here || !can_tell || known_share(picture, known_) > kOtherShareMax;
  const bool is_elsewhere =
      !goes_on && other_.size() >= kComparedMin && known_share(picture, other_) >= kSameShareMin;
  if (!goes_on && !is_elsewhere) {
    other_.assign(picture.begin(), picture.end());
    return false;
  }
  known_.assign(picture.begin(), picture.end());
  since_known_m_ = since_known_rad_ = 0;
  other_.clear();
  return is_elsewhere;
}

}  // namespace aisle
