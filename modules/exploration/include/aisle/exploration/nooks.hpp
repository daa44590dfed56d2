#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "aisle/exploration/gates.hpp"

namespace aisle {

struct NookParams {
  double edge_min_m = 0.3;       ///< a shorter edge of what is known is none
  double reach_m = 4.5;          ///< from so far a nook is looked into, at most
  double way_max_m = 3;          ///< a nook farther away waits until the vehicle comes by; 0: none matters
  double way_max_m_per_m2 = 60;  ///< the same by what it hides along its edge; the greater holds
  double again_m2 = 0.3;         ///< what hides so much along its edge is looked into twice

  /// Not worth a way of its own.
  bool is_far(const Gate& gate) const {
    return gate.is_nook && gate.way_m > std::max(way_max_m, way_max_m_per_m2 * gate.behind_m2);
  }
  /// When a look into it has shown nothing.
  bool is_worth_another_look(const Gate& gate) const {
    return !gate.is_nook || (gate.behind_m2 >= again_m2 && !is_far(gate));
  }

  void describe(FieldList& fields);
};

/// Nooks: floor that no gate leads to, but that can be seen from where the vehicle gets: behind a cupboard,
/// or in a room whose door is hardly open. Each is told as a gate that is not driven through: its sill is the
/// edge of the free floor, its rim right behind it in the unknown.
/// @param reached  measured with `gate_params.room_m`
/// @param gates  of the same floor
/// @param marks  to work with
std::vector<Gate> find_nooks(const FloorGrid& floor, const FloorClearance& clearance,
                             const FloorDistances& reached, std::span<const Gate> gates,
                             const GateParams& gate_params, const NookParams& params, CellMarks& marks);

}  // namespace aisle
