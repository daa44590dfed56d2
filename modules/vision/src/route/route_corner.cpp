#include "aisle/vision/route/route_corner.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace aisle {
namespace {

/// Whether two points belong to one obstacle's floor edge: the gaps between its points are small, but grow
/// with the distance from the camera.
bool is_one_floor_edge(const Vec2& p, const Vec2& q, const Vec2& p_camera, double gap_m) {
  constexpr double kNear_m = 1;
  const double away_m = std::max(kNear_m, (p - p_camera).norm());
  return (q - p).norm() < gap_m * away_m;
}

/// The direction of a floor edge at its end; nullopt: it is too short.
std::optional<Vec2> end_direction(std::span<const Vec2> floor_edge, double least_m) {
  constexpr double kEnough_m = 0.4;
  std::optional<Vec2> along;
  for (auto p = floor_edge.rbegin(); p != floor_edge.rend(); ++p) {
    const Vec2 last = floor_edge.back() - *p;
    if (last.norm() < least_m) continue;
    along = last;
    if (last.norm() >= kEnough_m) break;
  }
  return along;
}

}  // namespace

void RouteCornerParams::describe(FieldList& fields) {
  fields.real("side_min_m", side_min_m, {0.05, 5},
              "least length of the floor edge beside the route before the corner");
  fields.real("gap_m", gap_m, {0.02, 2}, "largest gap between points of one obstacle's floor edge, at 1 m");
  fields.real("beyond_m", beyond_m, {0.05, 5}, "least distance from the corner to what is seen beyond it");
  fields.angle("turn_deg", turn_rad, {1, 90}, "least turn off the route to what is seen beyond the corner");
  fields.real("reach_m", reach_m, {0.5, 20}, "farther corners are not used");
}

std::optional<Vec2> find_route_corner(std::span<const Vec2> p_vehicle_edges, const Vec2& p_vehicle_camera,
                                      RouteSide side, const RouteCornerParams& params) {
  std::vector<Vec2> inwards(p_vehicle_edges.begin(), p_vehicle_edges.end());
  if (side == RouteSide::kRight) std::reverse(inwards.begin(), inwards.end());
  const double sign = side == RouteSide::kLeft ? 1 : -1;
  const auto away_m = [&](const Vec2& p) { return (p - p_vehicle_camera).norm(); };
  std::size_t begin = 0;  // of the present floor edge
  for (std::size_t i = 0; i + 1 < inwards.size(); ++i) {
    const Vec2 &corner = inwards[i], &next = inwards[i + 1];
    if (is_one_floor_edge(corner, next, p_vehicle_camera, params.gap_m)) continue;
    const auto along = end_direction(std::span(inwards).subspan(begin, i + 1 - begin), params.side_min_m);
    begin = i + 1;
    if (!along || sign * corner.y() <= 0 || away_m(corner) > params.reach_m) continue;
    const bool goes_on_behind = away_m(next) >= away_m(corner) + params.beyond_m;
    if (goes_on_behind && sign * turn_between(*along, next - corner) >= params.turn_rad) return corner;
  }
  return std::nullopt;
}

}  // namespace aisle
