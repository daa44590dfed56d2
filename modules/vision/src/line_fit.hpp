#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Total least squares line through points.
struct LineFit {
  Vec2 centroid = Vec2::Zero();
  double heading_rad = 0;  ///< along the points, from the first to the last
  double rms_m = 0;        ///< of the distances across the line
  double spread_m2 = 0;    ///< sum of squared distances from the centroid along the line

  double distance(const Vec2& p) const { return left_normal(unit(heading_rad)).dot(p - centroid); }
};

/// Fits any range of a fixed sequence of points in constant time, from running sums.
class RangeLineFitter {
 public:
  /// The points must outlive the fitter's use.
  void assign(std::span<const Vec2> points);
  /// The line through points first .. last (inclusive); at least two points.
  LineFit fit(std::size_t first, std::size_t last) const;
  /// Sum of their squared distances across that line; much quicker than the line itself.
  double misfit(std::size_t first, std::size_t last) const;

 private:
  struct Sums {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  struct Spread {
    Vec2 centroid;
    double xx = 0, xy = 0, yy = 0;  ///< about it

    double contrast() const { return std::hypot(xx - yy, 2 * xy); }
    double across() const { return std::max(0.0, (xx + yy - contrast()) / 2); }
  };
  Spread spread(std::size_t first, std::size_t last) const;

  std::span<const Vec2> points_;
  std::vector<Sums> sums_;  ///< sums_[i]: over points 0 .. i-1
};

}  // namespace aisle
