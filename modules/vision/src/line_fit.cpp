#include "line_fit.hpp"

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

RangeLineFitter::Spread RangeLineFitter::spread(std::size_t first, std::size_t last) const {
  const Sums& a = sums_[first];
  const Sums& b = sums_[last + 1];
  const auto count = static_cast<double>(last + 1 - first);
  const Vec2 centroid = Vec2(b.x - a.x, b.y - a.y) / count;
  return {centroid, b.xx - a.xx - count * centroid.x() * centroid.x(),
          b.xy - a.xy - count * centroid.x() * centroid.y(),
          b.yy - a.yy - count * centroid.y() * centroid.y()};
}

LineFit RangeLineFitter::fit(std::size_t first, std::size_t last) const {
  const Spread s = spread(first, last);
  LineFit line{.centroid = s.centroid, .heading_rad = 0.5 * std::atan2(2 * s.xy, s.xx - s.yy)};
  if (unit(line.heading_rad).dot(points_[last] - points_[first]) < 0)
    line.heading_rad = wrap_angle(line.heading_rad + kPi);
  line.spread_m2 = (s.xx + s.yy + s.contrast()) / 2;
  line.rms_m = std::sqrt(s.across() / static_cast<double>(last + 1 - first));
  return line;
}

double RangeLineFitter::misfit(std::size_t first, std::size_t last) const {
  return spread(first, last).across();
}

}  // namespace aisle
