#pragma once

#include <vector>

#include "aisle/simulation/world.hpp"

namespace aisle {

/// What a vertical line belongs to.
enum class VerticalEdgeKind { kWall, kDoorFrame, kDoorLeaf, kPoster, kFurniture };

/// A vertical line of a world, as a point of its floor plan.
struct VerticalEdge {
  Vec2 p_world = Vec2::Zero();
  VerticalEdgeKind kind = VerticalEdgeKind::kWall;
};

/// All vertical lines of a world without people: where walls end or bend, the posts of door frames, open
/// doors' leaves, the sides of what hangs on walls (with the floor point below them), corners of furniture;
/// 24 around a round pillar. A sighting that is near none of them is not real.
std::vector<VerticalEdge> vertical_edges(const World& world);

}  // namespace aisle
