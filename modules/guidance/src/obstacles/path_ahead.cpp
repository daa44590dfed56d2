#include "aisle/guidance/obstacles/path_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kStep_m = 0.05;

}  // namespace

PathAhead path_ahead(const Path& path, const PathPoint& here, const Pose2& T_map_vehicle, double reach_m) {
  const std::size_t last = path.leg_end(here.piece) - 1;
  const double end_m = path.start_m(last) + path.pieces()[last].path_m();
  const auto steps = static_cast<int>(std::min(reach_m, end_m - here.along_m) / kStep_m);
  PathAhead ahead;
  for (int i = 0; i <= steps; ++i) {
    const double path_m = i * kStep_m;
    ahead.push_back({path_m, between(path.at(here.along_m + path_m).T_map_path, T_map_vehicle)});
  }
  return ahead;
}

std::optional<double> path_to(const Vec2& p_vehicle, const PathAhead& ahead, const Footprint& footprint,
                              double margin_m) {
  if (p_vehicle.x() <= footprint.front_m) return std::nullopt;
  const auto is_within = [&](const Waypoint& point) {
    const Vec2 p_there = point.T_there_vehicle * p_vehicle;
    return p_there.x() <= footprint.front_m && p_there.x() >= -footprint.rear_m &&
           std::abs(p_there.y()) <= footprint.width_m / 2 + margin_m;
  };
  const auto met = std::find_if(ahead.begin(), ahead.end(), is_within);
  if (met == ahead.end()) return std::nullopt;
  return std::max(0.0, met->path_m - kStep_m);
}

}  // namespace aisle
