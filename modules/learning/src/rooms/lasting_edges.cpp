#include "rooms/lasting_edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace aisle {
namespace {

/// What was seen in one cell of the floor.
struct EdgeCell {
  Vec2 sum = Vec2::Zero();
  int points = 0;
  int images = 0;
  double last_along_m = -1;
  double seen_from_m = 0;  ///< the least distance it was seen from

  Vec2 middle() const { return sum / points; }
};

/// Edges seen from far are inaccurate; a nearby edge that was seen from nearer replaces them.
bool is_superseded(const EdgeCell& cell, std::span<const EdgeCell> cells) {
  constexpr double kBeside_m = 0.25, kNearer = 0.7;
  return std::any_of(cells.begin(), cells.end(), [&](const EdgeCell& other) {
    return other.seen_from_m < kNearer * cell.seen_from_m &&
           (other.middle() - cell.middle()).norm() < kBeside_m;
  });
}

}  // namespace

std::vector<RouteEdge> lasting_edges(std::span<const RoomCycle> cycles,
                                     std::span<const Pose2> T_route_vehicle,
                                     const RoomLearningParams& params) {
  std::map<std::pair<int, int>, EdgeCell> cells;
  double along_m = 0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (i > 0) along_m += between(T_route_vehicle[i - 1], T_route_vehicle[i]).position().norm();
    for (const Vec2& p_vehicle : cycles[i].p_vehicle_edges) {
      const double off_m = p_vehicle.norm();
      if (off_m > params.edge_within_m) continue;
      const Vec2 p = T_route_vehicle[i] * p_vehicle, at = p / params.edge_apart_m;
      EdgeCell& cell = cells[{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))}];
      cell.sum += p;
      cell.seen_from_m = cell.points == 0 ? off_m : std::min(cell.seen_from_m, off_m);
      ++cell.points;
      // A vehicle that stands still sees nothing new.
      if (along_m > cell.last_along_m) ++cell.images;
      cell.last_along_m = along_m;
    }
  }
  std::vector<EdgeCell> lasting;
  for (const auto& [place, cell] : cells)
    if (cell.images >= params.edge_sightings) lasting.push_back(cell);
  std::vector<RouteEdge> edges;
  for (const EdgeCell& cell : lasting)
    if (!is_superseded(cell, lasting)) edges.push_back({cell.last_along_m, cell.middle()});
  std::stable_sort(edges.begin(), edges.end(),
                   [](const RouteEdge& a, const RouteEdge& b) { return a.along_m < b.along_m; });
  return edges;
}

}  // namespace aisle
