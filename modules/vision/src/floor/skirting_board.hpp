#pragma once

#include <optional>

#include "floor/floor_lines.hpp"
#include "floor/level_view.hpp"

namespace aisle {

/// Where a floor is nearly as dark as its skirting boards, the upper edge of a board is clearer than its
/// lower edge, and is taken for the floor's edge: the wall then seems farther away than it is.
struct SkirtingBoardParams {
  double camera_height_m = 1;
  double contrast_min = 5;     ///< of the faintest lower edge [grey levels]
  double height_max_m = 0.16;  ///< of a board
};

/// The lower edge of a board whose upper edge is `line`: the clearest step at one height beneath the line,
/// seen in every part of it. A line that is darker beyond, or has a clearer step above it, is the lower edge
/// already; what is beneath is the board's reflection or a pattern of the floor.
/// @return nullopt: no lower edge is seen beneath the line
std::optional<FloorLine> floor_point_beneath(const LevelView& view, const FloorLine& line,
                                             const SkirtingBoardParams& params);

}  // namespace aisle
