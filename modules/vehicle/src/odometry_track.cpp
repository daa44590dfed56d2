#include "aisle/vehicle/odometry_track.hpp"

#include <algorithm>
#include <iterator>

namespace aisle {
namespace {

constexpr double kCarryOn_s = 0.5;
constexpr double kCarriedOver_s = 0.04;  // the motion is measured over at least this; stamps jitter

Pose2 between_samples(const OdometrySample& a, const OdometrySample& b, double time_s) {
  const double span_s = b.time_s - a.time_s;
  return span_s > 0 ? interpolate(a.T_odom_vehicle, b.T_odom_vehicle, (time_s - a.time_s) / span_s)
                    : b.T_odom_vehicle;
}

}  // namespace

Pose2 OdometryTrack::at(double time_s, std::size_t known) const {
  const auto first = samples_.begin();
  const auto end = first + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(known, 1, samples_.size()));
  const auto later = std::upper_bound(
      first, end, time_s, [](double time, const OdometrySample& sample) { return time < sample.time_s; });
  if (later == first) return first->T_odom_vehicle;
  if (later != end) return between_samples(*(later - 1), *later, time_s);
  const OdometrySample& last = *(end - 1);
  if (time_s <= last.time_s || end - first < 2) return last.T_odom_vehicle;
  const auto before = std::find_if(
      std::reverse_iterator(end - 1), std::reverse_iterator(first),
      [&](const OdometrySample& sample) { return last.time_s - sample.time_s >= kCarriedOver_s; });
  if (before == std::reverse_iterator(first)) return last.T_odom_vehicle;
  return between_samples(*before, last, std::min(time_s, last.time_s + kCarryOn_s));
}

}  // namespace aisle
