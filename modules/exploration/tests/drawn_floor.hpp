#pragma once

#include <vector>

#include "aisle/exploration/nooks.hpp"

namespace aisle {

/// A floor drawn by hand: what is not put is unknown.
class DrawnFloor {
 public:
  void put(const Vec2& low, const Vec2& high, Floor kind) {
    for (double y = low.y() + 0.025; y < high.y(); y += 0.05) {
      for (double x = low.x() + 0.025; x < high.x(); x += 0.05) floor.set(floor.cell_at({x, y}), kind);
    }
  }

  /// A corridor along x, walls on both sides and at its left end.
  void put_corridor(double length_m, double width_m) {
    put({0, 0}, {length_m, width_m}, Floor::kFree);
    put({0, -0.05}, {length_m, 0}, Floor::kOccupied);
    put({0, width_m}, {length_m, width_m + 0.05}, Floor::kOccupied);
    put({-0.05, 0}, {0, width_m}, Floor::kOccupied);
  }

  std::vector<Gate> gates() {
    const FloorClearance clearance = clearance_now();
    return find_gates(floor, clearance, reached_now(clearance), params, marks);
  }

  std::vector<Gate> nooks() {
    const FloorClearance clearance = clearance_now();
    const FloorDistances reached = reached_now(clearance);
    return find_nooks(floor, clearance, reached, find_gates(floor, clearance, reached, params, marks), params,
                      nook_params, marks);
  }

  FloorClearance clearance_now() const {
    FloorClearance clearance;
    clearance.update(floor, floor.known());
    return clearance;
  }

  FloorGrid floor;
  CellMarks marks;
  GateParams params;
  NookParams nook_params;

 private:
  FloorDistances reached_now(const FloorClearance& clearance) const {
    FloorDistances reached;
    reached.measure(floor, clearance, {1, 1}, params.room_m, 1);
    return reached;
  }
};

}  // namespace aisle
