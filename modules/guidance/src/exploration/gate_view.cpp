#include "aisle/guidance/exploration/gate_view.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kFanEdge_rad = 3 * kDegree;  // nothing is expected to be seen so near to the fan's edge
constexpr double kSpareCells = 1.5;           // before a rim's point, where the unknown begins
constexpr double kCornerCells = 1;  // so much less is free about a point than about its cell's middle

/// Nothing stands, and nothing is unknown, between two places; of a nook's rim, what lies just before it may
/// be unknown.
bool is_clear(const FloorGrid& floor, const FloorClearance& clearance, const Vec2& from, const Vec2& to,
              bool is_nook) {
  const Vec2 way = to - from;
  const double length_m = way.norm();
  const double step_m = floor.cell_m() / 2;
  const double known_m = length_m - (is_nook ? Gate::kNookDepth_m : kSpareCells * floor.cell_m());
  const int steps = static_cast<int>(std::ceil((is_nook ? length_m : known_m) / step_m));
  for (int i = 0; i < steps;) {
    const double along_m = i * step_m;
    const FloorCell cell = floor.cell_at(from + way * (along_m / length_m));
    const Floor kind = floor.at(cell);
    if (kind == Floor::kOccupied || (kind == Floor::kUnknown && along_m < known_m)) return false;
    const double free_m = clearance.to_doubtful_m(cell) - kCornerCells * floor.cell_m();
    i += std::max(1, static_cast<int>(free_m / step_m));
  }
  return true;
}

}  // namespace

bool sees_rim(const GateLook& look, const FloorGrid& floor, const FloorClearance& clearance,
              const Pose2& T_map_vehicle, const Gate& gate, std::size_t enough) {
  const LaserScanner& fan = look.fan;
  const Pose2 T_map_fan = T_map_vehicle * fan.T_vehicle_laser;
  std::size_t seen = 0;
  for (const Vec2& p_map : gate.rim) {
    const Vec2 towards = p_map - T_map_fan.position();
    if (towards.norm() > look.reach_m) continue;
    const double angle_rad = wrap_angle(heading_of(towards) - T_map_fan.theta);
    if (angle_rad < fan.first_angle_rad + kFanEdge_rad || angle_rad > -fan.first_angle_rad - kFanEdge_rad)
      continue;
    const auto beam = static_cast<std::size_t>((angle_rad - fan.first_angle_rad) / fan.angle_step_rad);
    if (beam < look.near_m.size() && towards.norm() < look.near_m[beam]) continue;
    if (!is_clear(floor, clearance, T_map_fan.position(), p_map, gate.is_nook)) continue;
    if (++seen >= enough) return true;
  }
  return false;
}

}  // namespace aisle
