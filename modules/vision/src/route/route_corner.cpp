#include "aisle/vision/route/route_corner.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace aisle {
namespace {

/// One thing's floor point reaches from point to point with small gaps; farther away they are seen less
/// densely.
bool is_one_floor_point(const Vec2& p, const Vec2& q, const Vec2& p_camera, double gap_m) {
  constexpr double kNear_m = 1;
  const double away_m = std::max(kNear_m, (p - p_camera).norm());
  return (q - p).norm() < gap_m * away_m;
}

/// Which way a floor point leads at its end, over its last segment; nullopt: it is too short.
std::optional<Vec2> last_of_floor_point(std::span<const Vec2> floor_point, double least_m) {
  constexpr double kWished_m = 0.4;
  std::optional<Vec2> along;
  for (auto p = floor_point.rbegin(); p != floor_point.rend(); ++p) {
    const Vec2 last = floor_point.back() - *p;
    if (last.norm() < least_m) continue;
    along = last;
    if (last.norm() >= kWished_m) break;
  }
  return along;
}

/// Left positive.
double turn_between(const Vec2& from, const Vec2& to) {
  return wrap_angle(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()));
}

}  // namespace

void RouteCornerParams::describe(FieldList& fields) {
  fields.real("side_min_m", side_min_m, {0.05, 5}, "of what stands beside the route is seen before its end");
  fields.real("gap_m", gap_m, {0.02, 2}, "1 m away, between points of one thing's floor point");
  fields.real("beyond_m", beyond_m, {0.05, 5}, "farther away than the corner is what is seen next to it");
  fields.angle("turn_deg", turn_rad, {1, 90}, "away from the route is what is seen next to the corner");
  fields.real("reach_m", reach_m, {0.5, 20}, "farther corners are not looked for");
}

std::optional<Vec2> find_route_corner(std::span<const Vec2> p_vehicle_edges, const Vec2& p_vehicle_camera,
                                      RouteSide side, const RouteCornerParams& params) {
  std::vector<Vec2> inwards(p_vehicle_edges.begin(), p_vehicle_edges.end());
  if (side == RouteSide::kRight) std::reverse(inwards.begin(), inwards.end());
  const double sign = side == RouteSide::kLeft ? 1 : -1;
  const auto away_m = [&](const Vec2& p) { return (p - p_vehicle_camera).norm(); };
  std::size_t begin = 0;  // of what stands there
  for (std::size_t i = 0; i + 1 < inwards.size(); ++i) {
    const Vec2 &corner = inwards[i], &next = inwards[i + 1];
    if (is_one_floor_point(corner, next, p_vehicle_camera, params.gap_m)) continue;
    const auto along =
        last_of_floor_point(std::span(inwards).subspan(begin, i + 1 - begin), params.side_min_m);
    begin = i + 1;
    if (!along || sign * corner.y() <= 0 || away_m(corner) > params.reach_m) continue;
    const bool goes_on_behind = away_m(next) >= away_m(corner) + params.beyond_m;
    if (goes_on_behind && sign * turn_between(*along, next - corner) >= params.turn_rad) return corner;
  }
  return std::nullopt;
}

}  // namespace aisle
