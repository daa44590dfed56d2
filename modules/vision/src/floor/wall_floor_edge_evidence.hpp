#pragma once

#include <span>

#include "floor/floor_cells.hpp"
#include "floor/side_view.hpp"
#include "floor/wall_floor_edge.hpp"

namespace aisle {

/// A vertical line in a side view.
struct SideVertical {
  Vec2 top_px, bottom_px;
  double weight = 0;  ///< 0 to 1: long and of much contrast
};

/// What is known of a side view before wall-floor edges are searched.
struct SideScene {
  const SideView& view;
  Vec2 vanishing_point_px;
  std::span<const SideVertical> verticals;  ///< from left to right
  const FloorCells& floor;                  ///< of the image as it is, not of the view
};

/// Measures the evidence for and against a candidate: all that `WallFloorEdge::score` uses except `covered`,
/// which must be set.
void weigh(const SideScene& scene, WallFloorEdge& edge);

}  // namespace aisle
