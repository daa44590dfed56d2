#include "wall_joining.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/maps/cell_index.hpp"

namespace aisle {
namespace {

constexpr double kJoinLine_m = 0.05;      // both ends within this of the other's line
constexpr double kJoinDirection = 0.995;  // cosine of 6 degrees
constexpr double kJoinGap_m = 0.12;       // less than the thickness of most walls: they may lie in between
constexpr double kWithin_m = 0.05;        // of an end
constexpr int kPassesMax = 10;

Vec2 course_of(const Wall& wall) {
  return (wall.segment.end - wall.segment.start).normalized();
}

bool is_on_line(const Wall& wall, const Wall& host) {
  const Vec2 along = course_of(host);
  const auto off_m = [&](const Vec2& p) { return std::abs(cross(along, Vec2(p - host.segment.start))); };
  return along.dot(course_of(wall)) > kJoinDirection && off_m(wall.segment.start) < kJoinLine_m &&
         off_m(wall.segment.end) < kJoinLine_m;
}

/// Along the host's line, from its start.
Interval span_along(const Wall& host, const Wall& wall) {
  const Vec2 along = course_of(host);
  return {along.dot(wall.segment.start - host.segment.start),
          along.dot(wall.segment.end - host.segment.start)};
}

bool is_within(const Wall& wall, const Wall& host) {
  const Interval span = span_along(host, wall);
  return span.min > -kWithin_m && span.max < host.segment.length() + kWithin_m;
}

/// What a wall's position is worth, for a mean of several.
double worth_of(const Wall& wall) {
  return wall.segment.length() / std::max(1e-6, wall.sigma_m * wall.sigma_m);
}

void take_up(const Wall& wall, Wall& host) {
  const Vec2 along = course_of(host), normal = left_normal(along);
  const double share = worth_of(wall) / (worth_of(wall) + worth_of(host));
  const Vec2 aside = normal * (share * normal.dot(wall.segment.midpoint() - host.segment.start));
  const Interval span = span_along(host, wall);
  const double length_m = host.segment.length();
  const Vec2 origin = host.segment.start;
  if (span.min < 0) host.start = wall.start;
  if (span.max > length_m) host.end = wall.end;
  host.segment = {origin + aside + std::min(0.0, span.min) * along,
                  origin + aside + std::max(length_m, span.max) * along};
  host.sightings = std::max(host.sightings, wall.sightings);
  host.sigma_m = std::min(host.sigma_m, wall.sigma_m);
}

class Joining {
 public:
  /// Takes a wall into one of those before it that it belongs to, or adds it. @return whether it was taken in
  bool take(const Wall& wall) {
    index_.query(wall.segment.start, wall.segment.end, kJoinGap_m, near_);
    for (const int at : near_) {
      Wall& host = walls_[static_cast<std::size_t>(at)];
      if (!is_on_line(wall, host)) continue;
      if (host.evidence >= wall.evidence && is_within(wall, host)) return true;
      if (host.evidence != wall.evidence || host.is_orthogonal != wall.is_orthogonal) continue;
      if (Interval{0, host.segment.length()}.overlap(span_along(host, wall)) < -kJoinGap_m) continue;
      take_up(wall, host);
      index_.add(host.segment, at);
      return true;
    }
    index_.add(wall.segment, static_cast<int>(walls_.size()));
    walls_.push_back(wall);
    return false;
  }

  std::vector<Wall> walls() && { return std::move(walls_); }

 private:
  std::vector<Wall> walls_;
  CellIndex index_;
  std::vector<int> near_;
};

}  // namespace

std::vector<Wall> joined_walls(std::vector<Wall> walls) {
  bool has_joined = true;
  for (int pass = 0; has_joined && pass < kPassesMax; ++pass) {
    std::stable_sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) {
      return a.evidence != b.evidence ? a.evidence > b.evidence : a.segment.length() > b.segment.length();
    });
    has_joined = false;
    Joining joining;
    for (const Wall& wall : walls) has_joined |= joining.take(wall);
    walls = std::move(joining).walls();
  }
  return walls;
}

}  // namespace aisle
