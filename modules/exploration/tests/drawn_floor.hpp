#pragma once

#include <vector>

#include "aisle/exploration/pockets.hpp"

namespace aisle {

/// A floor drawn by hand: cells that are not put are unknown.
class DrawnFloor {
 public:
  explicit DrawnFloor(double cell_m = 0.05) : floor(cell_m) {}

  void put(const Vec2& low, const Vec2& high, Floor kind) {
    const double step_m = floor.cell_m();
    for (double y = low.y() + step_m / 2; y < high.y(); y += step_m) {
      for (double x = low.x() + step_m / 2; x < high.x(); x += step_m) floor.set(floor.cell_at({x, y}), kind);
    }
  }

  /// A corridor along x, walls on both sides and at its left end.
  void put_corridor(double length_m, double width_m) {
    put({0, 0}, {length_m, width_m}, Floor::kFree);
    put({0, -0.05}, {length_m, 0}, Floor::kOccupied);
    put({0, width_m}, {length_m, width_m + 0.05}, Floor::kOccupied);
    put({-0.05, 0}, {0, width_m}, Floor::kOccupied);
  }

  std::vector<Frontier> frontiers() {
    const KnownFloor known = known_now();
    return find_frontiers(known, reached_on(known), params, marks);
  }

  std::vector<Frontier> pockets() {
    const KnownFloor known = known_now();
    const FloorDistances reached = reached_on(known);
    return find_pockets(known, reached, find_frontiers(known, reached, params, marks), params, pocket_params,
                        marks);
  }

  KnownFloor known_now() const { return KnownFloor(floor); }

  FloorGrid floor;
  CellMarks marks;
  FrontierParams params;
  PocketParams pocket_params;

 private:
  FloorDistances reached_on(const KnownFloor& known) const {
    FloorDistances reached;
    reached.measure(known, {1, 1}, params.clearance_m, 1);
    return reached;
  }
};

}  // namespace aisle
