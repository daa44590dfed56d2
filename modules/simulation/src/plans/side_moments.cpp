#include "plans/side_moments.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/geometry/principal_direction.hpp"

namespace aisle {
namespace {

Moments operator+(const Moments& a, const Moments& b) {
  return {a.count + b.count, a.sum + b.sum, a.outer + b.outer};
}
Moments operator-(const Moments& a, const Moments& b) {
  return {a.count - b.count, a.sum - b.sum, a.outer - b.outer};
}

/// The sides of a straight run of n: evenly spaced, so that their variance along it is (n^2 - 1) / 12.
Moments moments_of_run(const Vec2& start, const Vec2& end) {
  const double n = (end - start).norm();
  const Vec2 mean = (start + end) / 2, along = (end - start) / n;
  return {n, n * mean, n * (mean * mean.transpose()) + n * (n * n - 1) / 12 * (along * along.transpose())};
}

}  // namespace

double Moments::squares_off_line() const {
  const Mat2 s = scatter();
  const double half_trace = s.trace() / 2;
  const double smaller = half_trace - std::hypot((s(0, 0) - s(1, 1)) / 2, s(0, 1));
  return std::max(0.0, smaller);
}

Vec2 Moments::direction() const {
  return principal_direction(scatter());
}

SideMoments::SideMoments(const Outline& outline) : before_(outline.size() + 1) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const LatticePoint a = outline[i], b = outline[(i + 1) % outline.size()];
    before_[i + 1] = before_[i] + moments_of_run(Vec2(a.x, a.y), Vec2(b.x, b.y));
  }
}

Moments SideMoments::between(std::size_t first, std::size_t last) const {
  const std::size_t runs = before_.size() - 1;
  const std::size_t rounds = first / runs;
  first -= rounds * runs;
  last -= rounds * runs;
  if (last <= runs) return before_[last] - before_[first];
  return before_[runs] - before_[first] + before_[last - runs];
}

}  // namespace aisle
