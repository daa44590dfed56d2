#include "aisle/formats/bags/bag_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aisle {
namespace {

constexpr double kFullCircle_rad = 360 * kDegree;

/// Whether an angle is a whole number of steps of 1/120 degree, as scanners' steps are: 1, 0.5, 0.25, 1/3
/// degree.
bool is_round(double angle_rad) {
  const double parts = std::abs(angle_rad) / kDegree * 120;
  return std::abs(parts - std::round(parts)) < 1e-3 * parts && std::round(parts) >= 1;
}

/// The angle from one reading to the next. angle_increment is right where angle_max is one reading too far,
/// as many drivers have it; the field of view is right where the increment was rounded, for its error adds
/// up.
double angle_step(const ros::LaserScan& message, double steps, ScanDoubts& doubts, long number) {
  const double increment = message.angle_increment;
  const double by_view = (double{message.angle_max} - message.angle_min) / steps;
  if (!std::isfinite(by_view) || by_view == 0) return increment;
  const double disagreement = std::abs(by_view / increment - 1) * steps;  // in readings
  if (disagreement <= 0.5) return increment;
  const auto take_view = [&] {
    if (doubts.angles_by_view++ == 0) doubts.first_by_view = number;
    return by_view;
  };
  const bool is_slight = std::abs(by_view / increment - 1) < 0.03;
  if (increment == 0 || std::abs(increment) * steps > 1.01 * kFullCircle_rad) return take_view();
  if (is_slight && !is_round(increment) && (is_round(by_view) || disagreement > 2)) return take_view();
  ++doubts.angles_by_step;
  return increment;
}

float usable(float range_m, float range_min_m, float range_max_m, ScanDoubts& doubts) {
  constexpr float kNothing = std::numeric_limits<float>::infinity();
  ++doubts.readings;
  if (range_m == kNothing) return kNothing;
  if (!(range_m >= 0)) return ++doubts.not_numbers, 0.0F;
  if (range_m < range_min_m || range_m == 0) return ++doubts.too_near, 0.0F;
  if (range_m > range_max_m) return ++doubts.too_far, kNothing;
  return range_m == range_max_m ? kNothing : range_m;
}

void reverse(BagScan& scan) {
  std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
  scan.beams.period_s = -scan.beams.period_s;
}

}  // namespace

std::string frame_name(const std::string& frame_id) {
  return frame_id.starts_with('/') ? frame_id.substr(1) : frame_id;
}

std::optional<BagScan> bag_scan(const ros::LaserScan& message, const MessageTime& time, ScanDoubts& doubts) {
  if (message.ranges.size() < 2 || !std::isfinite(message.angle_min) ||
      !std::isfinite(message.angle_increment))
    return std::nullopt;
  const double steps = static_cast<double>(message.ranges.size() - 1);
  const double step_rad = angle_step(message, steps, doubts, time.number);
  if (step_rad == 0 || std::abs(step_rad) * steps > 2 * kFullCircle_rad) return std::nullopt;
  BagScan scan;
  scan.time = time;
  scan.frame = frame_name(message.header.frame_id);
  const bool has_range_max = message.range_max > 0 && std::isfinite(message.range_max);
  scan.range_max_m = has_range_max ? message.range_max : 0;
  const float range_max_m = has_range_max ? message.range_max : std::numeric_limits<float>::infinity();
  scan.ranges_m.reserve(message.ranges.size());
  for (const float range_m : message.ranges)
    scan.ranges_m.push_back(usable(range_m, message.range_min, range_max_m, doubts));
  scan.scan_time_s = message.scan_time;
  const double period_s = std::isfinite(message.time_increment) ? message.time_increment : 0.0;
  scan.beams = {message.angle_min, step_rad, period_s};
  if (step_rad < 0) {
    scan.beams.first_angle_rad += step_rad * steps;
    scan.beams.angle_step_rad = -step_rad;
    reverse(scan);
  }
  return scan;
}

void turn_over(BagScan& scan) {
  const double steps = static_cast<double>(scan.ranges_m.size() - 1);
  scan.beams.first_angle_rad = -(scan.beams.first_angle_rad + scan.beams.angle_step_rad * steps);
  reverse(scan);
}

}  // namespace aisle
