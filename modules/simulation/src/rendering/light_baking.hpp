#pragma once

#include <span>
#include <vector>

#include "aisle/simulation/world.hpp"
#include "rendering/ray_scene.hpp"

namespace aisle {

/// Light on all sides of all surfaces, computed once with soft shadows. A texel holds the light from
/// everywhere in its lower and the light of the lamps in its upper half, both as shares of kLightMax.
struct LightTexels {
  static constexpr float kLightMax = 4;

  std::vector<std::uint32_t> texels;
};

/// Gives every surface its light maps. Light from everywhere is 1 in the open and less in corners; light of
/// lamps is 1 where the floor is well lit.
/// @param surfaces  one for each panel
LightTexels bake_light(const World& world, std::span<const Panel> panels, const RayScene& scene,
                       const SceneFrame& frame, std::span<ShadedSurface> surfaces);

std::uint32_t light_texel(float from_everywhere, float from_lamps);

}  // namespace aisle
