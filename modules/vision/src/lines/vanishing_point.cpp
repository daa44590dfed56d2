#include "lines/vanishing_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/square.hpp"

namespace aisle {

namespace {

constexpr std::size_t kPointVoters = 64;     // the longest segments
constexpr std::size_t kPointProposers = 28;  // of them, whose pairs are tried
constexpr double kLengthMin = 0.03;          // of a voter, as a share of the width
constexpr double kLengthCounted = 0.25;      // more of a voter does not count
constexpr double kFlattestSine = 0.14;       // sine of the angle to the horizontal and vertical: 8 degrees
constexpr double kApart = 0.12;              // sine of the least angle between two that propose
constexpr double kPointAgreement = 0.035;    // sine of the angle by which a voter may miss the point
constexpr double kNear = 0.04;               // voters nearer to the point say nothing: share of the width
constexpr double kVotesMin = 0.2;            // shares of the width
constexpr double kCentreAcross = 0.45;       // spread of the point about the middle, in widths ...
constexpr double kCentreDown = 0.28;         // ... and in heights about ...
constexpr double kCentreHeight = 0.45;       // ... this height
constexpr int kRefinements = 3;

}  // namespace

std::optional<Vec2> VanishingPointFinder::find(std::span<const EdgeSegment> segments, int width_px,
                                               int height_px) {
  width_px_ = width_px;
  height_px_ = height_px;
  gather(segments);
  std::optional<Vec2> best;
  double most = kVotesMin * width_px_;
  for (std::size_t i = 0; i < std::min(kPointProposers, voters_.size()); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double turn = cross(voters_[i].direction, voters_[j].direction);
      if (std::abs(turn) < kApart) continue;
      const double along = cross(voters_[j].middle_px - voters_[i].middle_px, voters_[j].direction) / turn;
      const Vec2 point_px = voters_[i].middle_px + along * voters_[i].direction;
      const double sum = votes(point_px);
      if (sum > most) {
        most = sum;
        best = point_px;
      }
    }
  }
  if (best) best = refined(*best);
  return best;
}

void VanishingPointFinder::gather(std::span<const EdgeSegment> segments) {
  voters_.clear();
  for (const EdgeSegment& segment : segments) {
    const Vec2 direction = segment.direction();
    if (segment.length_px() < kLengthMin * width_px_) continue;
    if (std::abs(direction.x()) < kFlattestSine || std::abs(direction.y()) < kFlattestSine) continue;
    voters_.push_back({segment.middle_px(), direction, segment.length_px(), direction.y() > 0});
  }
  std::sort(voters_.begin(), voters_.end(), [](const Voter& a, const Voter& b) {
    return std::pair(-a.length_px, a.middle_px.x()) < std::pair(-b.length_px, b.middle_px.x());
  });
  voters_.resize(std::min(voters_.size(), kPointVoters));
}

double VanishingPointFinder::votes(const Vec2& point_px) const {
  double falling = 0, rising = 0;
  for (const Voter& voter : voters_) {
    const Vec2 from = voter.middle_px - point_px;
    const double distance_squared = from.squaredNorm();
    if (distance_squared < square(kNear * width_px_)) continue;
    const double miss = square(cross(from, voter.direction)) / (square(kPointAgreement) * distance_squared);
    if (miss >= 1) continue;
    (voter.falls ? falling : rising) += std::min(voter.length_px, kLengthCounted * width_px_) * (1 - miss);
  }
  const double across = (point_px.x() / width_px_ - 0.5) / kCentreAcross;
  const double down = (point_px.y() / height_px_ - kCentreHeight) / kCentreDown;
  return (falling + rising + 2 * std::sqrt(falling * rising)) *
         std::exp(-0.5 * (square(across) + square(down)));
}

/// The point nearest to the voters' lines, each weighted by how well its length tells where it points.
Vec2 VanishingPointFinder::refined(Vec2 point_px) const {
  for (int round = 0; round < kRefinements; ++round) {
    Mat2 normals = Mat2::Zero();
    Vec2 offsets = Vec2::Zero();
    for (const Voter& voter : voters_) {
      const Vec2 from = voter.middle_px - point_px;
      const double distance_squared = from.squaredNorm();
      if (distance_squared < square(kNear * width_px_)) continue;
      if (square(cross(from, voter.direction)) > square(kPointAgreement) * distance_squared) continue;
      const Vec2 normal = left_normal(voter.direction);
      const double weight = square(voter.length_px) / distance_squared;
      normals += weight * normal * normal.transpose();
      offsets += weight * normal * normal.dot(voter.middle_px);
    }
    if (normals.determinant() < 1e-9) break;
    point_px = normals.inverse() * offsets;
  }
  return point_px;
}

}  // namespace aisle
