#include "leg_cutting.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace aisle {
namespace {

/// The best line and the best circle through points that come one after the other.
class PointSums {
 public:
  void add(const Vec2& p) {
    const double q = p.squaredNorm();
    const Vec3 row{p.x(), p.y(), 1};
    moments_ += row * row.transpose();
    with_square_ += q * row;
    square_square_ += q * q;
    last_ = p;
  }

  /// Sum of squared distances from the best line.
  double off_line_m2() const {
    const double n = moments_(2, 2);
    const double xx = moments_(0, 0) - moments_(0, 2) * moments_(0, 2) / n;
    const double yy = moments_(1, 1) - moments_(1, 2) * moments_(1, 2) / n;
    const double xy = moments_(0, 1) - moments_(0, 2) * moments_(1, 2) / n;
    return std::max(0.0, (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy));
  }

  struct Circle {
    double curvature_per_m = 0;
    double off_m2 = std::numeric_limits<double>::infinity();
  };

  /// The circle of least algebraic distance, with its sum of squared distances.
  Circle circle() const {
    const Vec3 solution = moments_.ldlt().solve(with_square_);  // x^2 + y^2 = solution . (x, y, 1)
    const Vec2 centre = solution.head<2>() / 2;
    const double radius2 = solution.z() + centre.squaredNorm();
    if (!(radius2 > 0) || !std::isfinite(radius2)) return {};
    const double algebraic = std::max(0.0, square_square_ - solution.dot(with_square_));
    const double side = cross(last_, centre);
    return {std::copysign(1 / std::sqrt(radius2), side), algebraic / (4 * radius2)};
  }

 private:
  Mat3 moments_ = Mat3::Zero();
  Vec3 with_square_ = Vec3::Zero();
  double square_square_ = 0;
  Vec2 last_ = Vec2::Zero();
};

enum PathSegmentKind : std::size_t { kLine, kArc };

/// The cheapest cuts of the samples up to one of them, by the kind of the last segment.
struct Cut {
  double cost = std::numeric_limits<double>::infinity();
  std::size_t first = 0;
  PathSegmentKind kind_before = kArc;
  double curvature_per_m = 0;
};
using Cuts = std::array<Cut, 2>;

void improve(Cut& cut, const Cut& tried) {
  if (tried.cost < cut.cost) cut = tried;
}

PathSegmentKind cheapest(const Cuts& cuts) {
  return cuts[kLine].cost <= cuts[kArc].cost ? kLine : kArc;
}

}  // namespace

std::vector<PathSegment> cut_leg(std::span<const Pose2> samples, double step_m, double radius_min_m,
                                 double price_m3) {
  constexpr std::size_t kLongest = 600;
  constexpr std::size_t kShortest = 3;
  constexpr double kTurnMax_rad = 0.75 * std::numbers::pi;
  const std::size_t count = samples.size();
  std::vector<Cuts> cuts(count);
  cuts[0][kArc].cost = cuts[0][kLine].cost = 0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    PointSums sums;
    const PathSegmentKind before = cheapest(cuts[i]);
    const double best = cuts[i][before].cost;
    const double after_arc = i == 0 ? 0 : cuts[i][kArc].cost;
    if (!std::isfinite(best)) continue;
    for (std::size_t j = i; j < count && j - i <= kLongest; ++j) {
      sums.add(samples[j].position() - samples[i].position());
      const bool is_whole = i == 0 && j + 1 == count;
      if (j == i || (j - i < kShortest && !is_whole)) continue;
      improve(cuts[j][kLine], {after_arc + step_m * sums.off_line_m2() + price_m3 / 2, i, kArc, 0});
      if (j - i < kShortest || best + price_m3 >= cuts[j][kArc].cost) continue;
      const PointSums::Circle circle = sums.circle();
      const double curvature_per_m = std::clamp(circle.curvature_per_m, -1 / radius_min_m, 1 / radius_min_m);
      const double turn_rad = std::abs(curvature_per_m) * static_cast<double>(j - i) * step_m;
      if (turn_rad > kTurnMax_rad) continue;
      improve(cuts[j][kArc], {best + step_m * circle.off_m2 + price_m3, i, before, curvature_per_m});
    }
  }
  std::vector<PathSegment> path_segments;
  PathSegmentKind kind = cheapest(cuts.back());
  for (std::size_t last = count - 1; last > 0;) {
    const Cut& cut = cuts[last][kind];
    path_segments.push_back({cut.first, last, cut.curvature_per_m});
    last = cut.first;
    kind = cut.kind_before;
  }
  std::reverse(path_segments.begin(), path_segments.end());
  return path_segments;
}

}  // namespace aisle
