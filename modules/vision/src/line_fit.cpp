#include "line_fit.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {

void RangeLineFitter::assign(std::span<const Vec2> points) {
  points_ = points;
  sums_.assign(1, {});
  for (const Vec2& p : points) {
    const Sums& s = sums_.back();
    sums_.push_back(
        {s.x + p.x(), s.y + p.y(), s.xx + p.x() * p.x(), s.xy + p.x() * p.y(), s.yy + p.y() * p.y()});
  }
}

LineFit RangeLineFitter::fit(std::size_t first, std::size_t last) const {
  const Sums& a = sums_[first];
  const Sums& b = sums_[last + 1];
  const auto count = static_cast<double>(last + 1 - first);
  LineFit line;
  line.centroid = Vec2(b.x - a.x, b.y - a.y) / count;
  const double xx = b.xx - a.xx - count * line.centroid.x() * line.centroid.x();
  const double xy = b.xy - a.xy - count * line.centroid.x() * line.centroid.y();
  const double yy = b.yy - a.yy - count * line.centroid.y() * line.centroid.y();
  const double trace = xx + yy;
  const double contrast = std::hypot(xx - yy, 2 * xy);
  line.heading_rad = 0.5 * std::atan2(2 * xy, xx - yy);
  if (unit(line.heading_rad).dot(points_[last] - points_[first]) < 0)
    line.heading_rad = wrap_angle(line.heading_rad + kPi);
  line.spread_m2 = (trace + contrast) / 2;
  line.rms_m = std::sqrt(std::max(0.0, (trace - contrast) / 2) / count);
  return line;
}

}  // namespace aisle
