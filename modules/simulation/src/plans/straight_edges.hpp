#pragma once

#include <cstddef>
#include <vector>

#include "plans/cell_outlines.hpp"

namespace aisle {

/// Part of an outline that can be one straight wall: the runs from corner `first` to corner `last`, counted
/// round the outline; last > first, and may be beyond the outline's end.
struct OutlineSegment {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Cuts a closed outline at as few of its corners as possible, such that the middles of the cells' sides
/// between two cuts lie within `tolerance` [cells] of a straight line; among equals the cuts with the
/// smallest sum of squares. The segments follow each other round the outline.
std::vector<OutlineSegment> straight_edges(const Outline& outline, double tolerance);

}  // namespace aisle
