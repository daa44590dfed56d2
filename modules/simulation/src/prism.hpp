#pragma once

#include <vector>

#include "aisle/simulation/world.hpp"

namespace aisle {

/// An upright solid: obstacles for collisions are made of these, and so is what a camera sees.
struct Prism {
  std::vector<Vec2> outline;  ///< convex, clockwise: the outside is on the left
  double bottom_m = 0;
  double top_m = 1;
};

Prism box(const Pose2& T_world_box, const Vec2& size, double bottom_m, double top_m);

/// A round or oval pillar; its corners lie on the ellipse.
Prism pillar(const Pose2& T_world_pillar, const Vec2& size, double bottom_m, double top_m, int sides);

std::vector<Prism> parts_of(const Furniture& piece);

Prism leaf_of(const Door& door);

inline constexpr double kFrameRelief_m =
    0.025;  ///< how far a door's frame stands out from the wall, on either side
inline constexpr double kFrameInside_m = 0.01;  ///< how far it reaches into the opening

/// At the hinge and at the lock; none if the door has no frame.
std::vector<Prism> frame_posts_of(const Door& door);

}  // namespace aisle
