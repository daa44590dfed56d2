#pragma once

#include <span>

#include "rendering/packet.hpp"
#include "rendering/surface.hpp"

namespace aisle {

/// How bright the light is that is baked into light maps.
struct LightLevels {
  float from_everywhere = 0.35f;
  float from_lamps = 0.65f;
  float glow = 1;  ///< of the lamps themselves
};

/// A light plane at a height, sent out by a projector.
struct LaserPlane {
  std::array<float, 3> projector{};
  std::array<float, 2> ahead{1, 0};  ///< it shines to this side
  float strength = 0;                ///< 0: off
};

/// What shading looks at, whole arrays each.
struct ShadingTables {
  std::span<const Material> materials;
  std::span<const Texture> textures;
  const std::uint32_t* light_texels = nullptr;
};

/// The light that comes back along those rays that hit the surface; the other lanes' values mean nothing.
void shade(const ShadedSurface& surface, const ShadingTables& tables, const LightLevels& levels,
           const RayPacket& rays, const Flags& on_surface, Floats& radiance);

/// The share of the light that a polished floor mirrors (Schlick 1994), lane by lane.
void find_mirrored(float gloss, const RayPacket& rays, Floats& mirrored);

/// The laser stripe if nothing blocks the light plane: the light of the lanes on the surface, and the segment
/// to the projector in `segments`, asked for where there is light.
/// @return whether there is any light; if not, stripe and segments are undefined
bool shade_stripe(const ShadedSurface& surface, const LaserPlane& laser, const RayPacket& rays,
                  const Flags& on_surface, Floats& stripe, SegmentPacket& segments);

}  // namespace aisle
