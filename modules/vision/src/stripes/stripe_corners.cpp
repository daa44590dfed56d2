#include "stripes/stripe_corners.hpp"

#include <algorithm>
#include <cmath>

#include "line_fit.hpp"

namespace aisle {
namespace {

constexpr std::size_t kFewest = 4;  // points of a segment that can be known from noise

/// The indices where a polyline is split, its ends included.
class Splitter {
 public:
  Splitter(std::span<const Vec2> points, double tolerance) : points_(points), tolerance_(tolerance) {
    fitter_.assign(points);
  }

  std::vector<std::size_t> ends() {
    ends_ = {0};
    split(0, points_.size() - 1);
    merge();
    return ends_;
  }

  LineFit line(std::size_t first, std::size_t last) const { return fitter_.fit(first, last); }

 private:
  void split(std::size_t first, std::size_t last) {
    const Vec2 along = (points_[last] - points_[first]).normalized();
    std::size_t farthest = first;
    double distance = tolerance_;
    for (std::size_t i = first + kFewest; i + kFewest <= last; ++i) {
      const double off = std::abs(left_normal(along).dot(points_[i] - points_[first]));
      if (off > distance) {
        distance = off;
        farthest = i;
      }
    }
    if (farthest != first) split(first, farthest);
    if (farthest != first)
      split(farthest, last);
    else
      ends_.push_back(last);
  }

  /// Neighbours that one line fits as well are one segment.
  void merge() {
    for (std::size_t i = 1; i + 1 < ends_.size();) {
      if (fitter_.fit(ends_[i - 1], ends_[i + 1]).rms_m < tolerance_ / 3)
        ends_.erase(ends_.begin() + static_cast<std::ptrdiff_t>(i));
      else
        ++i;
    }
  }

  std::span<const Vec2> points_;
  double tolerance_;
  RangeLineFitter fitter_;
  std::vector<std::size_t> ends_;
};

Vec2 projected(const Vec2& p, const LineFit& line) {
  return p - line.distance(p) * left_normal(unit(line.heading_rad));
}

/// Where two lines cross, if that is near `p`; else `p`.
Vec2 crossing_near(const Vec2& p, const LineFit& a, const LineFit& b, double reach) {
  const Vec2 along = unit(a.heading_rad);
  const double across = left_normal(unit(b.heading_rad)).dot(along);
  if (std::abs(across) < 1e-6) return p;
  const Vec2 start = projected(p, a);
  const Vec2 crossing = start - b.distance(start) / across * along;
  return (crossing - p).norm() <= reach ? crossing : p;
}

}  // namespace

std::vector<Vec2> polyline_corners(std::span<const Vec2> points, double tolerance) {
  Splitter splitter(points, tolerance);
  const std::vector<std::size_t> ends = splitter.ends();
  std::vector<LineFit> lines;
  for (std::size_t i = 1; i < ends.size(); ++i) lines.push_back(splitter.line(ends[i - 1], ends[i]));
  std::vector<Vec2> corners = {projected(points.front(), lines.front())};
  for (std::size_t i = 1; i < lines.size(); ++i)
    corners.push_back(crossing_near(points[ends[i]], lines[i - 1], lines[i], 3 * tolerance));
  corners.push_back(projected(points.back(), lines.back()));
  return corners;
}

}  // namespace aisle
