#include "aisle/geometry/dominant_direction.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kLengthMin_m = 1.5;
constexpr double kTolerance_rad = 2.5 * kDegree;

/// Mean of the headings near `seed_rad`, weighted by length, and the length that agrees.
struct Support {
  double heading_rad = 0;
  double length_m = 0;
};

Support support_of(double seed_rad, std::span<const SensedSegment> segments) {
  double off = 0, length_m = 0;
  for (const SensedSegment& s : segments) {
    const double difference = wrap_quarter_turn(s.heading_rad - seed_rad);
    if (s.curved || std::abs(difference) > kTolerance_rad) continue;
    off += s.length_m * difference;
    length_m += s.length_m;
  }
  return {length_m > 0 ? seed_rad + off / length_m : seed_rad, length_m};
}

}  // namespace

std::optional<DominantDirection> dominant_direction(std::span<const SensedSegment> segments) {
  double seen_m = 0;
  Support best;
  for (const SensedSegment& s : segments) {
    seen_m += s.length_m;
    if (s.curved) continue;
    const Support support = support_of(s.heading_rad, segments);
    if (support.length_m > best.length_m) best = support;
  }
  if (seen_m < kLengthMin_m) return std::nullopt;
  const Support refined = support_of(best.heading_rad, segments);
  return DominantDirection{wrap_quarter_turn(refined.heading_rad), refined.length_m / seen_m};
}

}  // namespace aisle
