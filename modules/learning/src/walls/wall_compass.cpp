#include "aisle/learning/walls/wall_compass.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/core/cauchy.hpp"
#include "aisle/core/square.hpp"
#include "aisle/geometry/dominant_direction.hpp"

namespace aisle {
namespace {

constexpr double kShareMin = 0.6;  // least share of edges along two axes: others are not a corridor's
constexpr double kFirstSigma_rad = 1 * kDegree;  // of the first image
constexpr double kLeastSigma_rad = 0.15 * kDegree;
constexpr double kBends_rad = 0.1 * kDegree;  // per metre of path: walls and map are not quite straight
constexpr double kBelievedHeading = 3;        // standard deviations within which walls are the known ones
constexpr double kUsual_rad = 1 * kDegree;    // usual deviation of the known walls
constexpr int kUnlikeMax = 30;  // images in a row with other directions, before these become the known ones
constexpr double kNewErrors_m = 0.3;             // path after which an image has wholly new errors ...
constexpr double kNewErrors_rad = 10 * kDegree;  // ... or turn
constexpr double kStanding = 0.003;              // share of these below which the vehicle stands

/// Misaligned edges (open doors, furniture) count less.
std::optional<HeadingMeasurement> heading_near(std::span<const SensedSegment> edges, double predicted_rad,
                                               double predicted_sigma_rad) {
  double information = 0, turn_rad = 0;
  for (const SensedSegment& edge : edges) {
    const auto misfit = misfit_to_axis(edge, predicted_rad);
    if (!misfit || edge.curved) continue;
    const double usual_rad = std::hypot(misfit->usual_rad, predicted_sigma_rad);
    const double weight = square(cauchy_weight(misfit->off_rad, usual_rad) / misfit->sigma_rad);
    information += weight;
    turn_rad -= weight * misfit->off_rad;
  }
  if (information == 0) return std::nullopt;
  return HeadingMeasurement{predicted_rad + turn_rad / information, std::sqrt(1 / information)};
}

}  // namespace

void WallCompass::start(const std::optional<WallDirection>& walls) {
  *this = {};
  if (!walls) return;
  walls_rad_ = walls->direction_rad;
  variance_ = square(walls->sigma_rad);
  starts_ = 1;
}

void WallCompass::move(double path_m, double turn_rad) {
  variance_ += square(kBends_rad) * path_m;
  new_share_ += path_m / kNewErrors_m + std::abs(turn_rad) / kNewErrors_rad;
}

void WallCompass::look(std::span<const SensedSegment> edges, double heading_rad, double sigma_rad) {
  heading_variance_ = square(sigma_rad);
  against_walls_.reset();
  if (new_share_ < kStanding) return;
  const double information_share = std::min(1.0, std::exchange(new_share_, 0));
  if (starts_ == 0 || unlike_ > kUnlikeMax) {
    const auto seen = dominant_direction(edges);
    if (!seen || seen->share < kShareMin) return;
    walls_rad_ = heading_rad + seen->heading_rad;
    variance_ = square(kFirstSigma_rad) + heading_variance_;
    unlike_ = 0;
    ++starts_;
  }
  const double predicted_rad = heading_rad - walls_rad_;
  const double predicted_variance = heading_variance_ + variance_;
  against_walls_ = heading_near(edges, predicted_rad, std::sqrt(predicted_variance));
  if (!against_walls_) return;
  const double off_rad = against_walls_->heading_rad - predicted_rad;
  const bool is_like =
      std::abs(off_rad) < kBelievedHeading * std::sqrt(predicted_variance + square(kUsual_rad));
  unlike_ = is_like ? 0 : unlike_ + 1;
  if (is_like) {
    against_walls_->sigma_rad /= std::sqrt(information_share);
  } else {
    against_walls_.reset();
  }
}

std::optional<HeadingMeasurement> WallCompass::heading() const {
  if (!against_walls_ || heading_variance_ <= variance_) return std::nullopt;
  return HeadingMeasurement{wrap_angle(walls_rad_ + against_walls_->heading_rad),
                            std::hypot(against_walls_->sigma_rad, std::sqrt(variance_))};
}

void WallCompass::learn(double heading_rad, double sigma_rad) {
  if (!against_walls_) return;
  const double off_rad = wrap_angle(heading_rad - against_walls_->heading_rad - walls_rad_);
  const double gain = variance_ / (variance_ + square(sigma_rad) + square(against_walls_->sigma_rad));
  walls_rad_ += gain * off_rad;
  variance_ = std::max((1 - gain) * variance_, square(kLeastSigma_rad));
}

}  // namespace aisle
