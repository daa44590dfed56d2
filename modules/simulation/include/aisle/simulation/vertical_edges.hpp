#pragma once

#include <vector>

#include "aisle/simulation/world.hpp"

namespace aisle {

/// What stands where a vertical line may be seen.
enum class VerticalEdgeKind { kWall, kDoorFrame, kDoorLeaf, kPoster, kFurniture };

/// A vertical line of a world, as a point of its floor plan.
struct VerticalEdge {
  Vec2 p_world = Vec2::Zero();
  VerticalEdgeKind kind = VerticalEdgeKind::kWall;
};

/// All vertical lines of a world, people excepted; a round pillar has 24 of them round it: where
/// walls end or bend, the posts of door frames, open doors' leaves, the sides of what hangs on walls (their
/// foot is below them), furniture's corners. A sighting that is near none of them is not real.
std::vector<VerticalEdge> vertical_edges(const World& world);

}  // namespace aisle
