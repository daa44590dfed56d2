#include "aisle/missions/route_rules.hpp"

#include <fmt/format.h>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kRouteCheckEvery_m = 0.05;

std::string why_off_limits(const Building& building, std::span<const Barrier> lines, const Path& path,
                           const PathPoint& point, const Footprint& footprint) {
  const Pose2& T_map = point.T_map_path;
  if (const Zone* zone = keep_out_around(building.zones, T_map.position()))
    return fmt::format("leads through the {}", words_for(*zone));
  if (const Barrier* met = barrier_met(lines, footprint, T_map))
    return fmt::format("meets a barrier of the building ({})", words_for(met->kind));
  const Gear gear = gear_of(path.pieces()[point.piece].arc.length_m);
  const Zone* against = one_way_against(building.zones, T_map, gear);
  return against == nullptr ? "" : fmt::format("leads against the {}", words_for(*against));
}

}  // namespace

Problems check_floor_rules(const Building& building, const std::string& route, const Path& path,
                           const Footprint& footprint) {
  const std::vector<Barrier> lines = lines_not_crossed(building);
  if ((lines.empty() && building.zones.empty()) || path.empty()) return {};
  const auto steps = static_cast<int>(path.length_m() / kRouteCheckEvery_m);
  for (int i = 0; i <= steps; ++i) {
    const PathPoint point = path.at(i * kRouteCheckEvery_m);
    const std::string why = why_off_limits(building, lines, path, point, footprint);
    if (why.empty()) continue;
    return {{{"", 0, "route"},
             fmt::format("'{}' {} near {:.1f}, {:.1f}", route, why, point.T_map_path.x, point.T_map_path.y)}};
  }
  return {};
}

}  // namespace aisle
