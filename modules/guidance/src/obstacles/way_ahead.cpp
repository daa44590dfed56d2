#include "aisle/guidance/obstacles/way_ahead.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kStep_m = 0.05;

}  // namespace

WayAhead way_ahead(const Path& path, const PathPoint& here, const Pose2& T_map_vehicle, double reach_m) {
  const std::size_t last = path.leg_end(here.piece) - 1;
  const double end_m = path.start_m(last) + path.pieces()[last].way_m();
  const auto steps = static_cast<int>(std::min(reach_m, end_m - here.along_m) / kStep_m);
  WayAhead way;
  for (int i = 0; i <= steps; ++i) {
    const double way_m = i * kStep_m;
    way.push_back({way_m, between(path.at(here.along_m + way_m).T_map_path, T_map_vehicle)});
  }
  return way;
}

std::optional<double> way_to(const Vec2& p_vehicle, const WayAhead& way, const Footprint& footprint,
                             double margin_m) {
  if (p_vehicle.x() <= footprint.front_m) return std::nullopt;
  const auto is_within = [&](const WayPoint& point) {
    const Vec2 p_there = point.T_there_vehicle * p_vehicle;
    return p_there.x() <= footprint.front_m && p_there.x() >= -footprint.rear_m &&
           std::abs(p_there.y()) <= footprint.width_m / 2 + margin_m;
  };
  const auto met = std::find_if(way.begin(), way.end(), is_within);
  if (met == way.end()) return std::nullopt;
  return std::max(0.0, met->way_m - kStep_m);
}

}  // namespace aisle
