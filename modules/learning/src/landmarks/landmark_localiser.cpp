#include "aisle/learning/landmarks/landmark_localiser.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "landmarks/landmark_view.hpp"

namespace aisle {
namespace {

constexpr double kSureWeight = 0.5;              // landmarks of this weight surely exist
constexpr int kContradictingMin = 2;             // this many of them missing contradict the map
constexpr double kStanding_m = 0.01;             // images taken within this have the same errors ...
constexpr double kStanding_rad = 0.2 * kDegree;  // ... unless the vehicle has turned this far
constexpr double kCoincidenceMax = 3 * LandmarkLocaliser::kPairEvidence;  // three pairs, however good
constexpr double kFarSurer = 0.5;  // ratio of sigmas: walls this much surer than the heading correct it first
constexpr double kBehindDistance = 2;  // added to the squared distance if only seen from behind

}  // namespace

void LandmarkLocaliserParams::describe(FieldList& fields) {
  fields.group("mwght", mwght);
  fields.real("confidence_m2", confidence_m2, {0.01, 1000},
              "Cd: landmarks farther away than its root count less");
  fields.real("window_sigmas", window_sigmas, {1, 10},
              "displacements within this many standard deviations are tried");
  fields.real("window_min_m", window_min_m, {0, 5}, "displacements up to this are always tried");
  fields.angle("window_min_deg", window_min_rad, {0, 45}, "turns up to this are always tried");
  fields.real("window_max_m", window_max_m, {0.1, 10}, "larger displacements are never tried");
  fields.angle("window_max_deg", window_max_rad, {0, 90}, "larger turns are never tried");
  fields.real("ambiguous_share", ambiguous_share, {0.1, 1},
              "a second displacement whose pairs agree at least this share as well makes a match ambiguous");
  fields.real("gate_sigmas", gate_sigmas, {1, 10},
              "a sighting farther from a landmark is not paired with it");
  fields.real(
      "together_sigmas", together_sigmas, {1, 10},
      "a few pairs farther off the odometry's prediction than this (root mean square) are coincidence");
  fields.real("landmark_sigma_m", landmark_sigma_m, {0, 1}, "least sigma of a landmark's position");
  fields.real("repeat_inflation", repeat_inflation, {1, 100},
              "images in a row are not independent: their variances are multiplied by this");
  fields.real("matched_share_min", matched_share_min, {0, 1},
              "with less of the sightings matched there is no match");
  fields.count("pairs_min", pairs_min, {1, 20}, "fewer sightings than this make no match");
  fields.flag("polarity", polarity,
              "a line that is brighter on its right is never taken for one that is brighter left");
  fields.flag("covariance", covariance, "errors along and across the line of sight are kept apart");
  fields.flag("heading_by_walls", heading_by_walls, "floor edges along the walls correct the heading, too");
}

/// A runner-up on the flank of the best peak is refined to the same place: it is not a separate hypothesis.
bool LandmarkLocaliser::is_elsewhere(const Pose2& best, const Pose2& other) const {
  const Pose2 off = between(best, other);
  return off.position().norm() > params_.mwght.apart_m / 2 ||
         std::abs(off.theta) > params_.mwght.apart_rad / 2;
}

LandmarkLocaliser::LandmarkLocaliser(const LandmarkLocaliserParams& params, const VehicleDescription& vehicle,
                                     const UncertainPose2& T_map_vehicle)
    : params_(params), filter_(vehicle, T_map_vehicle), mwght_(params.mwght) {}

void LandmarkLocaliser::predict(const OdometryReading& reading) {
  const Pose2 before = filter_.pose();
  filter_.predict(reading);
  const Pose2 moved = between(before, filter_.pose());
  since_here_m_ += moved.position().norm();
  compass_.move(moved.position().norm(), moved.theta);
  since_here_rad_ += std::abs(moved.theta);
  if (since_here_m_ >= kStanding_m || since_here_rad_ >= kStanding_rad) taken_in_here_ = 0;
}

void LandmarkLocaliser::place(const UncertainPose2& T_map_vehicle,
                              const std::optional<WallDirection>& walls) {
  filter_.place(T_map_vehicle);
  compass_.start(walls);
  taken_in_here_ = 0;
}

void LandmarkLocaliser::correct_heading(const HeadingMeasurement& measured) {
  const double off_rad = wrap_angle(measured.heading_rad - filter_.pose().theta);
  filter_.correct(off_rad, Vec3::UnitZ(), measured.sigma_rad);
}

LandmarkMatch LandmarkLocaliser::correct(const LandmarkMap& map, std::span<const LandmarkSighting> sightings,
                                         std::span<const SensedSegment> floor_edges) {
  const bool sees_walls = params_.heading_by_walls && !floor_edges.empty();
  if (!sees_walls) return correct_by_landmarks(map, sightings);
  compass_.look(floor_edges, filter_.pose().theta, heading_sigma_rad());
  const auto by_walls = compass_.heading();
  const bool is_far_surer = by_walls && by_walls->sigma_rad < kFarSurer * heading_sigma_rad();
  if (is_far_surer) correct_heading(*by_walls);
  const LandmarkMatch found = correct_by_landmarks(map, sightings);
  if (is_far_surer) return found;
  if (found == LandmarkMatch::kMatched) {
    compass_.learn(filter_.pose().theta, heading_sigma_rad());
  } else if (by_walls && found != LandmarkMatch::kUnmatched) {
    correct_heading(*by_walls);
  }
  return found;
}

LandmarkMatch LandmarkLocaliser::correct_by_landmarks(const LandmarkMap& map,
                                                      std::span<const LandmarkSighting> sightings) {
  pairs_.clear();
  matched_share_ = 0;
  agreement_ = 0;
  evidence_ = 0;
  patterns_.gather(map, sightings, filter_.pose(), params_.confidence_m2, window(), params_.mwght.reach_m);
  if (patterns_.learned.empty()) return LandmarkMatch::kNothing;
  const auto match = mwght_.match(patterns_.learned, patterns_.seen, window());
  if (!match) return without_match(map, sightings);
  Pose2 T_map_guess = filter_.pose() * match->best.displacement;
  pair_up(map, sightings, T_map_guess);
  if (match->runner_up && is_elsewhere(match->best.displacement, match->runner_up->displacement)) {
    const Pose2 T_map_other = filter_.pose() * match->runner_up->displacement;
    first_pairs_ = pairs_;
    const double first = agreement_;
    pair_up(map, sightings, T_map_other);
    // Equal pairs at two displacements leave a direction open, which the filter handles.
    const bool is_other_place = pairs_ != first_pairs_;
    if (is_other_place &&
        std::min(first, agreement_) > params_.ambiguous_share * std::max(first, agreement_)) {
      pairs_.clear();
      return LandmarkMatch::kAmbiguous;
    }
    if (agreement_ > first) {
      T_map_guess = T_map_other;
    } else {
      pair_up(map, sightings, T_map_guess);
    }
  }
  if (!has_matched()) return without_match(map, sightings);
  if (!is_believable(T_map_guess)) {
    T_map_guess = filter_.pose();
    pair_up(map, sightings, T_map_guess);
    if (!has_matched() || !is_believable(T_map_guess)) return without_match(map, sightings);
  }
  take_in(T_map_guess);
  return LandmarkMatch::kMatched;
}

/// Whether enough of the sightings are paired at the current guess.
bool LandmarkLocaliser::has_matched() const {
  return pairs_.size() >= static_cast<std::size_t>(params_.pairs_min) &&
         matched_share_ >= params_.matched_share_min;
}

/// A few sightings are easily paired with wrong landmarks somewhere in the window. So all pairs must be
/// consistent with the prediction, unless there are so many that the prediction is more likely wrong.
bool LandmarkLocaliser::is_believable(const Pose2& T_map_guess) const {
  return evidence_ > kCoincidenceMax ||
         filter_.squared_distance(points_, T_map_guess) <=
             square(params_.together_sigmas) * static_cast<double>(points_.size());
}

/// The variances of the n-th image from one place count n^2 times: all of them together say less than two
/// images from two places.
void LandmarkLocaliser::take_in(const Pose2& T_map_guess) {
  if (taken_in_here_ == 0) since_here_m_ = since_here_rad_ = 0;
  ++taken_in_here_;
  for (SeenPoint& point : points_)
    point.covariance *= params_.repeat_inflation * square(static_cast<double>(taken_in_here_));
  filter_.update(points_, T_map_guess);
}

/// Unknown sightings alone do not contradict the map. The vehicle may be elsewhere only if several of the
/// landmarks expected from the believed pose, and most of them, are missing.
LandmarkMatch LandmarkLocaliser::without_match(const LandmarkMap& map,
                                               std::span<const LandmarkSighting> sightings) {
  pair_up(map, sightings, filter_.pose());
  if (has_matched()) return LandmarkMatch::kNothing;
  const LandmarkView view(sightings);
  int missing = 0, seen = 0;
  for (std::size_t k = 0; k < patterns_.near.size(); ++k) {
    const Landmark& landmark = map[static_cast<std::size_t>(patterns_.near[k])];
    if (landmark.weight >= kSureWeight && view.expects(landmark, filter_.pose()))
      ++(taken_[k] ? seen : missing);
  }
  return missing >= kContradictingMin && missing > seen ? LandmarkMatch::kUnmatched : LandmarkMatch::kNothing;
}

MwghtWindow LandmarkLocaliser::window() const {
  const Mat3 covariance = filter_.covariance();
  const Vec2 ahead = unit(filter_.pose().theta), left = left_normal(ahead);
  const auto half = [&](double variance, double least, double most) {
    return std::clamp(params_.window_sigmas * std::sqrt(variance), least, most);
  };
  const Mat2 position = covariance.topLeftCorner<2, 2>();
  return {.x_half_m = half(ahead.dot(position * ahead), params_.window_min_m, params_.window_max_m),
          .y_half_m = half(left.dot(position * left), params_.window_min_m, params_.window_max_m),
          .turn_half_rad = half(covariance(2, 2), params_.window_min_rad, params_.window_max_rad)};
}

/// Pairs every sighting with the most likely landmark, by the errors of both: of two equally many standard
/// deviations away, the one that is known better. A landmark is taken once, preferably one that was seen from
/// this side.
void LandmarkLocaliser::pair_up(const LandmarkMap& map, std::span<const LandmarkSighting> sightings,
                                const Pose2& T_map_vehicle) {
  pairs_.clear();
  points_.clear();
  taken_.assign(patterns_.near.size(), 0);
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  const Mat2 R_map_vehicle = rotation(T_map_vehicle.theta);
  double matched = 0, all = 0, agreement = 0;
  evidence_ = 0;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const LandmarkSighting& sighting = sightings[i];
    all += patterns_.seen[i].weight;
    double nearest = 0, least_unlikely = std::numeric_limits<double>::infinity();
    std::size_t best = patterns_.near.size();
    Mat2 best_covariance = Mat2::Identity();
    for (std::size_t k = 0; k < patterns_.near.size(); ++k) {
      const Landmark& landmark = map[static_cast<std::size_t>(patterns_.near[k])];
      if (taken_[k] || (params_.polarity && landmark.brighter_right != sighting.brighter_right)) continue;
      const Mat2 known = R_map_vehicle.transpose() * landmark.covariance * R_map_vehicle +
                         square(params_.landmark_sigma_m) * Mat2::Identity();
      const Mat2 covariance = params_.covariance
                                  ? Mat2(sighting.covariance + known)
                                  : Mat2(Mat2::Identity() * (sighting.covariance + known).trace() / 2);
      const Vec2 off = sighting.p_vehicle - T_vehicle_map * landmark.p_map;
      const double behind = is_known_from_behind(landmark, T_map_vehicle.position()) ? kBehindDistance : 0;
      const double distance = off.dot(covariance.inverse() * off) + behind;
      if (distance >= square(params_.gate_sigmas)) continue;
      const double unlikely = distance + std::log(covariance.determinant());
      if (unlikely >= least_unlikely) continue;
      least_unlikely = unlikely;
      nearest = distance;
      best = k;
      best_covariance = covariance;
    }
    if (best == patterns_.near.size()) continue;
    taken_[best] = 1;
    matched += patterns_.seen[i].weight;
    agreement += patterns_.seen[i].weight * std::exp(-nearest / 2);
    evidence_ += std::max(0.0, kPairEvidence - nearest / 2);
    const std::size_t landmark = static_cast<std::size_t>(patterns_.near[best]);
    pairs_.push_back({i, landmark});
    const Vec2 by_tilt = params_.covariance ? sighting.by_tilt : Vec2(Vec2::Zero());
    points_.push_back({.p_map = map[landmark].p_map,
                       .p_vehicle = sighting.p_vehicle,
                       .covariance = best_covariance - by_tilt * by_tilt.transpose(),
                       .by_tilt = by_tilt});
  }
  matched_share_ = matched / all;
  agreement_ = agreement / all;
}

}  // namespace aisle
