#pragma once

#include <array>
#include <vector>

#include "corridors/clear_floor.hpp"

namespace aisle {

/// The eight cells around a cell that is not on the border, counter-clockwise from the right.
std::array<std::size_t, 8> cells_around(const ClearFloor& floor, std::size_t cell);

/// Lines of single cells, connected over sides and corners, along the middle of an area: thinned from the
/// edge inwards without ever splitting it or closing a hole, except where a ridge of the clearance ends.
/// @param area             none of its cells on the border
/// @param ridge_slope_max  where the clearance grows faster than this in some direction there is no ridge:
///                         0.7 is the diagonal of a right-angled corner, 0 the middle of a corridor
std::vector<bool> skeleton(const ClearFloor& floor, std::vector<bool> area, double ridge_slope_max);

}  // namespace aisle
