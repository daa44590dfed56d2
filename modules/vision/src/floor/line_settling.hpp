#pragma once

#include "floor/floor_lines.hpp"
#include "floor/level_view.hpp"

namespace aisle {

/// Brings a line to the floor point of what stands there. Before a wall the floor lies in its shadow, the
/// deeper the nearer to the floor point: column by column the step that lasts seems to be there, nearer than
/// the wall is, and the more so the nearer the wall. Of all columns together the floor point is where a wall
/// that changes little, a step, and light that comes back with the distance from the floor point explain the
/// brightness best; its ends may be off the line by unlike amounts.
FloorLine settled_line(const LevelView& view, const FloorLine& line);

}  // namespace aisle
