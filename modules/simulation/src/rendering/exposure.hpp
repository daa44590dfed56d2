#pragma once

#include <vector>

#include "rendering/lens_table.hpp"
#include "rendering/scene.hpp"
#include "rendering/sensor_response.hpp"
#include "rendering/viewpoints.hpp"

namespace aisle {

/// Upper left pixel of a packet.
struct Block {
  int u = 0, v = 0;
};

/// The rays of a packet's pixels, aside of their middles by an offset [px].
RayPacket block_rays(const LensTable& lens, Block block, const Viewpoint& view, float offset_u,
                     float offset_v);

/// One picture in the making. First one ray a pixel finds what is seen where; then each pixel is shaded: by
/// one ray where a single surface is seen all around, as patterns are filtered by what a pixel sees of them,
/// and by several where surfaces meet.
class Exposure {
 public:
  Exposure(const RenderedWorld::Scene& scene, const LensTable& lens, std::vector<Viewpoint> views,
           const LightLevels& levels, const LaserPlane& laser, int rays_per_pixel);

  /// @param exposure  light is multiplied by it before the sensor
  Image develop(const SensorResponse& response, double exposure) const;

 private:
  void find_surfaces();
  bool has_one_surface(Block block) const;
  void add_light(const RayPacket& rays, const Hits& hits, Floats& sum) const;
  void add_stripe(const RayPacket& rays, const Hits& hits, Floats& light) const;
  Floats light_of(Block block) const;
  int blocks_wide() const { return (lens_.width_px + kPacketSide - 1) / kPacketSide; }
  int blocks_high() const { return (lens_.height_px + kPacketSide - 1) / kPacketSide; }

  const RenderedWorld::Scene& scene_;
  const LensTable& lens_;
  std::vector<Viewpoint> views_;
  LightLevels levels_;
  LaserPlane laser_;
  int samples_;
  std::vector<Hits> seen_;  ///< by the middle of each pixel, packet by packet
};

}  // namespace aisle
