#include "aisle/maps/zone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr const char* kZoneWords[] = {"keep-out zone", "slow zone", "one-way zone"};

/// Whether a test is true of some edge of the outline.
template <class Test>
bool any_edge(const Zone& zone, Test test) {
  const std::size_t corners = zone.outline.size();
  for (std::size_t i = 0; i < corners; ++i) {
    if (test(Segment2{zone.outline[i], zone.outline[(i + 1) % corners]})) return true;
  }
  return false;
}

}  // namespace

std::string words_for(const Zone& zone) {
  const char* words = kZoneWords[static_cast<std::size_t>(zone.kind)];
  return zone.name.empty() ? words : fmt::format("{} '{}'", words, zone.name);
}

/// A ray to the right crosses the outline an odd number of times.
bool contains(const Zone& zone, const Vec2& p_map) {
  bool is_inside = false;
  const std::size_t corners = zone.outline.size();
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec2 &start = zone.outline[i], &end = zone.outline[(i + 1) % corners];
    if ((start.y() > p_map.y()) == (end.y() > p_map.y())) continue;
    const double share = (p_map.y() - start.y()) / (end.y() - start.y());
    if (p_map.x() < start.x() + share * (end.x() - start.x())) is_inside = !is_inside;
  }
  return is_inside;
}

const Zone* keep_out_around(std::span<const Zone> zones, const Vec2& p_map) {
  const auto around = std::find_if(zones.begin(), zones.end(), [&](const Zone& zone) {
    return zone.kind == Zone::Kind::kKeepOut && contains(zone, p_map);
  });
  return around == zones.end() ? nullptr : &*around;
}

bool overlaps(const Zone& zone, const Footprint& footprint, const Pose2& T_map_vehicle) {
  if (contains(zone, T_map_vehicle.position())) return true;
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  return any_edge(zone, [&](const Segment2& edge) { return meets(footprint, T_vehicle_map * edge); });
}

double speed_max_mps(std::span<const Zone> zones, const Footprint& footprint, const Pose2& T_map_vehicle) {
  double speed_mps = std::numeric_limits<double>::infinity();
  for (const Zone& zone : zones) {
    if (zone.kind == Zone::Kind::kSlow && overlaps(zone, footprint, T_map_vehicle))
      speed_mps = std::min(speed_mps, zone.speed_max_mps);
  }
  return speed_mps;
}

const Zone* one_way_against(std::span<const Zone> zones, const Pose2& T_map_vehicle, Gear gear,
                            double off_max_rad) {
  const double direction_rad = gear == Gear::kForward ? T_map_vehicle.theta : T_map_vehicle.theta + kPi;
  const auto against = std::find_if(zones.begin(), zones.end(), [&](const Zone& zone) {
    return zone.kind == Zone::Kind::kOneWay &&
           std::abs(wrap_angle(direction_rad - zone.direction_rad)) > off_max_rad &&
           contains(zone, T_map_vehicle.position());
  });
  return against == zones.end() ? nullptr : &*against;
}

std::vector<Barrier> outlines(std::span<const Zone> zones) {
  std::vector<Barrier> barriers;
  for (const Zone& zone : zones) {
    if (zone.kind != Zone::Kind::kKeepOut) continue;
    for (std::size_t i = 0; i < zone.outline.size(); ++i) {
      const Vec2& next = zone.outline[(i + 1) % zone.outline.size()];
      barriers.push_back({Barrier::Kind::kKeepOut, {zone.outline[i], next}});
    }
  }
  return barriers;
}

}  // namespace aisle
