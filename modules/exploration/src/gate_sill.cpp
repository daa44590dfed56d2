#include "gate_sill.hpp"

#include <algorithm>

namespace aisle {

void measure_sill(const FloorGrid& floor, Gate& gate) {
  Vec2 middle = Vec2::Zero();
  for (const FloorCell cell : gate.sill) {
    gate.box.include(cell);
    middle += floor.centre(cell) / static_cast<double>(gate.sill.size());
  }
  const auto nearest = std::min_element(gate.sill.begin(), gate.sill.end(), [&](FloorCell a, FloorCell b) {
    return (floor.centre(a) - middle).squaredNorm() < (floor.centre(b) - middle).squaredNorm();
  });
  gate.p_map = floor.centre(*nearest);
}

}  // namespace aisle
