#pragma once

#include "floor/floor_lines.hpp"
#include "floor/level_view.hpp"

namespace aisle {

/// Moves a line to where the wall meets the floor. The floor before a wall lies in its shadow, which is
/// deepest at the wall: in a single column the lasting step seems to be where the shadow begins, too near,
/// and the more so the nearer the wall. Over all columns together, the wall-floor edge is where a wall of
/// nearly constant brightness, a step, and light that returns with the distance explain the brightness best.
/// The two ends of the line may move by different amounts.
FloorLine settled_line(const LevelView& view, const FloorLine& line);

}  // namespace aisle
