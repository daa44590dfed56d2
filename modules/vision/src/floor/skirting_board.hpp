#pragma once

#include <optional>

#include "floor/floor_lines.hpp"
#include "floor/level_view.hpp"

namespace aisle {

/// Above floors that are nearly as dark as their skirting boards the upper edge of a board is clearer than
/// its floor point, and is taken for the floor's edge: all of that wall then seems farther away than it is.
struct SkirtingBoardParams {
  double camera_height_m = 1;
  double contrast_min = 5;     ///< grey levels of the faintest floor point
  double height_max_m = 0.16;  ///< of a board
};

/// The floor point of a board whose upper edge a line is: the clearest step at one height beneath all of the
/// line, there in every part of it. A line beyond which it is darker, or that has a clearer one above it, is
/// a floor point already, and what is beneath is the board's reflection or a pattern of the floor.
/// @return nullopt: no floor point is seen beneath the line
std::optional<FloorLine> floor_point_beneath(const LevelView& view, const FloorLine& line,
                                             const SkirtingBoardParams& params);

}  // namespace aisle
