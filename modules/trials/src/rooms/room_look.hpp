#pragma once

#include "aisle/core/parameters.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Changes to the look of a trial's rooms, in teaching and in driving alike.
struct RoomLook {
  double ambient_share = 1;
  double floor_contrast = 0;
  double floor_gloss = 0;
  double like_floor_share = 0;

  void describe(FieldList& fields) {
    fields.real("ambient_share", ambient_share, {0, 1},
                "factor on the ambient light: less makes shadows darker");
    fields.real("floor_contrast", floor_contrast, {0, 1},
                "contrast of a carpet's pattern; 0: the world's own floor");
    fields.real("floor_gloss", floor_gloss, {0, 1}, "gloss of a polished floor; 0: the world's own");
    fields.real("like_floor_share", like_floor_share, {0, 1},
                "how far the furniture's brightness is moved to the floor's; 1: the same");
  }

  void apply(World& world) const {
    world.ambient_light *= ambient_share;
    if (floor_contrast > 0) {
      world.floor.kind = FloorCovering::Kind::kCarpet;
      world.floor.contrast = floor_contrast;
    }
    if (floor_gloss > 0) world.floor.gloss = floor_gloss;
    for (Furniture& piece : world.furniture)
      piece.brightness += like_floor_share * (world.floor.brightness - piece.brightness);
  }
};

}  // namespace aisle
