#include "aisle/guidance/exploration/frontier_view.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kScanEdge_rad = 3 * kDegree;  // the outermost beams are not relied on
constexpr double kClearanceCells = 1.5;        // before a frontier's edge, where the unknown begins
constexpr double kCornerCells = 1;  // a point's clearance is at most this much less than its cell centre's

/// Whether the line of sight crosses neither obstacles nor unknown floor. Just before a pocket's edge the
/// floor may be unknown.
bool is_clear(const KnownFloor& floor, const Vec2& from, const Vec2& path, double length_m, bool is_pocket) {
  const FloorGrid& grid = floor.grid();
  const Vec2 along = path / length_m;
  const double step_m = grid.cell_m() / 2;
  const double known_m = length_m - (is_pocket ? Frontier::kPocketDepth_m : kClearanceCells * grid.cell_m());
  const int steps = static_cast<int>(std::ceil((is_pocket ? length_m : known_m) / step_m));
  for (int i = 0; i < steps;) {
    const double passed_m = i * step_m;
    const FloorCell cell = grid.cell_at(from + passed_m * along);
    const double free_m = floor.clearance().to_doubtful_m(cell);
    if (free_m <= 0) {
      const Floor kind = grid.at(cell);
      if (kind == Floor::kOccupied || (kind == Floor::kUnknown && passed_m < known_m)) return false;
    }
    i += std::max(1, static_cast<int>((free_m - kCornerCells * grid.cell_m()) / step_m));
  }
  return true;
}

/// The point lies beyond the beam's blind zone.
bool shows_beam(const FrontierLook& look, const Pose2& T_map_scanner, const Vec2& towards,
                double distance_m) {
  if (look.near_m.empty()) return true;
  const double angle_rad = wrap_angle(heading_of(towards) - T_map_scanner.theta);
  const auto beam =
      static_cast<std::size_t>((angle_rad - look.scanner.first_angle_rad) / look.scanner.angle_step_rad);
  return beam >= look.near_m.size() || distance_m >= look.near_m[beam];
}

}  // namespace

bool sees_frontier(const FrontierLook& look, const KnownFloor& floor, const Pose2& T_map_vehicle,
                   const Frontier& frontier, std::size_t enough) {
  const Pose2 T_map_scanner = T_map_vehicle * look.scanner.T_vehicle_laser;
  const Vec2 ahead = unit(T_map_scanner.theta);
  const double cosine_least = std::cos(look.scanner.first_angle_rad + kScanEdge_rad);
  std::size_t seen = 0, left = frontier.edge.size();
  for (const Vec2& p_map : frontier.edge) {
    if (seen + left-- < enough) return false;
    const Vec2 towards = p_map - T_map_scanner.position();
    const double distance_m = towards.norm();
    const bool is_in_fan = ahead.dot(towards) >= cosine_least * distance_m;
    if (distance_m > look.reach_m || !is_in_fan || !shows_beam(look, T_map_scanner, towards, distance_m))
      continue;
    if (!is_clear(floor, T_map_scanner.position(), towards, distance_m, frontier.is_pocket)) continue;
    if (++seen >= enough) return true;
  }
  return false;
}

}  // namespace aisle
