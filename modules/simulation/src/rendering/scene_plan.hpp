#pragma once

#include <span>
#include <vector>

#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "prism.hpp"
#include "rendering/materials.hpp"

namespace aisle {

using Panels = std::vector<Panel>;

/// The sides, the top, and the bottom if it does not stand on the floor.
void add_prism(const Prism& prism, int material, Panels& panels);

/// Floor, ceiling, walls and skirting boards.
void add_rooms(const World& world, Materials& materials, Panels& panels);
/// Door leaves, their frames, and the walls above them.
void add_doors(const World& world, Materials& materials, Panels& panels);
/// What hangs, lies and stands there.
void add_furnishing(const World& world, Materials& materials, Panels& panels);

void add_body(const MovingBody& body, Materials& materials, Panels& panels);

/// Lower left and upper right corner of all that stands in the world, with some room around it.
struct Extent {
  Vec2 min, max;

  Vec2 centre() const { return (min + max) / 2; }
  Vec2 size() const { return max - min; }
};
Extent extent_of(const World& world);

}  // namespace aisle
