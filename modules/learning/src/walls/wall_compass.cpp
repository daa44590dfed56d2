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

constexpr double kShareMin = 0.6;                // of edges along two axes: others are no corridor's
constexpr double kFirstSigma_rad = 1 * kDegree;  // of a first look
constexpr double kLeastSigma_rad = 0.15 * kDegree;
constexpr double kBends_rad = 0.1 * kDegree;  // in a metre of path, of map and walls
constexpr double kBelieved = 3;               // standard deviations
constexpr double kUsual_rad = 1 * kDegree;    // of walls that are the ones that are known
constexpr int kUnlikeMax = 30;                // images in a row in which walls run otherwise
constexpr double kTellsAgain_m = 0.3;         // of path: images that are taken on it have the same errors ...
constexpr double kTellsAgain_rad = 10 * kDegree;  // ... as have those on such a turn
constexpr double kStanding = 0.003;               // of either

/// Edges that lie misaligned (open doors, furniture) count the less the more.
std::optional<HeadingMeasurement> heading_near(std::span<const SensedSegment> edges, double foretold_rad,
                                               double foretold_sigma_rad) {
  double information = 0, turn_rad = 0;
  for (const SensedSegment& edge : edges) {
    const auto misfit = misfit_to_axis(edge, foretold_rad);
    if (!misfit || edge.curved) continue;
    const double usual_rad = std::hypot(misfit->usual_rad, foretold_sigma_rad);
    const double weight = square(cauchy_weight(misfit->off_rad, usual_rad) / misfit->sigma_rad);
    information += weight;
    turn_rad -= weight * misfit->off_rad;
  }
  if (information == 0) return std::nullopt;
  return HeadingMeasurement{foretold_rad + turn_rad / information, std::sqrt(1 / information)};
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
  again_ += path_m / kTellsAgain_m + std::abs(turn_rad) / kTellsAgain_rad;
}

void WallCompass::look(std::span<const SensedSegment> edges, double heading_rad, double sigma_rad) {
  heading_variance_ = square(sigma_rad);
  against_walls_.reset();
  if (again_ < kStanding) return;
  const double information_share = std::min(1.0, std::exchange(again_, 0));
  if (starts_ == 0 || unlike_ > kUnlikeMax) {
    const auto seen = dominant_direction(edges);
    if (!seen || seen->share < kShareMin) return;
    walls_rad_ = heading_rad + seen->heading_rad;
    variance_ = square(kFirstSigma_rad) + heading_variance_;
    unlike_ = 0;
    ++starts_;
  }
  const double foretold_rad = heading_rad - walls_rad_;
  const double foretold_variance = heading_variance_ + variance_;
  against_walls_ = heading_near(edges, foretold_rad, std::sqrt(foretold_variance));
  if (!against_walls_) return;
  const double off_rad = against_walls_->heading_rad - foretold_rad;
  const bool is_like = std::abs(off_rad) < kBelieved * std::sqrt(foretold_variance + square(kUsual_rad));
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
