#include "landmarks/point_fit.hpp"

#include <cmath>

namespace aisle {

Pose2 fit_points(std::span<const PointPair> pairs) {
  Vec2 from_mean = Vec2::Zero(), to_mean = Vec2::Zero();
  for (const PointPair& pair : pairs) {
    from_mean += pair.from / static_cast<double>(pairs.size());
    to_mean += pair.to / static_cast<double>(pairs.size());
  }
  double along = 0, across = 0;
  for (const PointPair& pair : pairs) {
    const Vec2 from = pair.from - from_mean, to = pair.to - to_mean;
    along += from.dot(to);
    across += cross(from, to);
  }
  const double theta = std::atan2(across, along);
  const Vec2 offset = to_mean - rotate(theta, from_mean);
  return {offset.x(), offset.y(), theta};
}

}  // namespace aisle
