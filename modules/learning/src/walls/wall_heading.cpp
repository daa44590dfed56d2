#include "aisle/learning/walls/wall_heading.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr double kSeenMin_m = 1.5;
constexpr double kWindowMax_rad = 12 * kDegree;
constexpr double kSeedLength_m = 0.4;  // shorter segments do not start a mode
constexpr double kModeWidth_rad = 1.5 * kDegree;
constexpr double kReach_rad = 4 * kDegree;  // segments farther from the mode are not of this frame
constexpr double kAgree_rad = 2.5 * kDegree;
constexpr double kAgreeShare = 0.5;
constexpr double kNoiseFloor_rad = 0.3 * kDegree;
constexpr double kSecondDirection_m = 0.6;  // with this much wall in both directions the heading is surer
constexpr double kBothSigma_rad = 0.7 * kDegree;
constexpr double kOneSigma_rad = 1.5 * kDegree;
constexpr double kEdgeMin_m = 0.3;             // a shorter edge has no direction
constexpr double kSteady_rad = 0.7 * kDegree;  // steadiness of an edge's direction, whoever looks
constexpr double kEdgeYawError_rad = 1.5 * kDegree;
constexpr double kKnown_rad = 3 * kDegree;  // a less sure direction is as often a door's, a shadow's ...
constexpr double kLongEdge_m = 1.5;         // ... unless the edge is this long

/// A segment's angle to the nearest axis if the sensor had this heading.
double off_axis_rad(const SensedSegment& segment, double heading_rad) {
  return wrap_quarter_turn(heading_rad + segment.heading_rad);
}

/// The heading near the prediction that the most wall length supports.
std::optional<double> strongest_mode(std::span<const SensedSegment> segments, double predicted_rad,
                                     double window_rad) {
  std::optional<double> mode;
  double best_score = 0;
  for (const SensedSegment& seed : segments) {
    if (seed.curved || seed.length_m < kSeedLength_m) continue;
    const double turn = -off_axis_rad(seed, predicted_rad);
    if (std::abs(turn) > window_rad) continue;
    double score = 0;
    for (const SensedSegment& s : segments) {
      if (s.curved) continue;
      const double off = off_axis_rad(s, predicted_rad + turn);
      score += s.length_m * std::exp(-0.5 * square(off / (kModeWidth_rad + s.sigma_heading_rad)));
    }
    score *= std::exp(-0.5 * square(turn / window_rad));
    if (score > best_score) {
      best_score = score;
      mode = predicted_rad + turn;
    }
  }
  return mode;
}

}  // namespace

std::optional<AxisMisfit> misfit_to_axis(const SensedSegment& edge, double heading_rad) {
  if (edge.length_m < kEdgeMin_m) return std::nullopt;
  if (edge.length_m < kLongEdge_m && edge.sigma_heading_rad > kKnown_rad) return std::nullopt;
  return AxisMisfit{.off_rad = off_axis_rad(edge, heading_rad),
                    .sigma_rad = std::hypot(edge.sigma_heading_rad, kSteady_rad),
                    .usual_rad = std::hypot(edge.sigma_heading_rad, kEdgeYawError_rad)};
}

std::optional<HeadingMeasurement> heading_from_walls(std::span<const SensedSegment> segments,
                                                     double predicted_rad, double predicted_sigma_rad) {
  double seen_m = 0;
  for (const SensedSegment& s : segments) seen_m += s.length_m;
  if (seen_m < kSeenMin_m) return std::nullopt;
  const double window_rad = std::min(kWindowMax_rad, 3 * predicted_sigma_rad + 3 * kDegree);
  const auto mode = strongest_mode(segments, predicted_rad, window_rad);
  if (!mode) return std::nullopt;

  double heading = *mode, weight_sum = 0, agreeing_m = 0;
  for (int round = 0; round < 3; ++round) {
    double weighted_turn = 0;
    weight_sum = agreeing_m = 0;
    for (const SensedSegment& s : segments) {
      const double turn = -off_axis_rad(s, heading);
      if (s.curved || std::abs(turn) > kReach_rad) continue;
      const double weight =
          1 / (square(s.sigma_heading_rad) + square(kNoiseFloor_rad)) / (1 + square(turn / kModeWidth_rad));
      weighted_turn += weight * turn;
      weight_sum += weight;
      if (std::abs(turn) < kAgree_rad) agreeing_m += s.length_m;
    }
    if (weight_sum <= 0) return std::nullopt;
    heading += weighted_turn / weight_sum;
  }
  if (agreeing_m < kAgreeShare * seen_m || agreeing_m < kSeenMin_m) return std::nullopt;

  double along_m[2] = {0, 0};
  for (const SensedSegment& s : segments) {
    const double turn = -off_axis_rad(s, heading);
    if (s.curved || std::abs(turn) > kAgree_rad) continue;
    const auto quarter_turns = std::lround((heading + s.heading_rad + turn) / (kPi / 2));
    along_m[quarter_turns & 1] += s.length_m;
  }
  const double frame_sigma =
      std::min(along_m[0], along_m[1]) > kSecondDirection_m ? kBothSigma_rad : kOneSigma_rad;
  return HeadingMeasurement{wrap_angle(heading), std::sqrt(1 / weight_sum + square(frame_sigma))};
}

}  // namespace aisle
