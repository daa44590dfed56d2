#pragma once

#include <vector>

#include "rendering/lens_table.hpp"
#include "rendering/scene.hpp"
#include "rendering/sensor_response.hpp"
#include "rendering/viewpoints.hpp"

namespace aisle {

/// The rays of a block's pixels, each at an offset from its pixel's middle [px].
RayPacket block_rays(const LensTable::Block& block, const Viewpoint& view, const Floats& offset_u,
                     const Floats& offset_v);

/// What came through the lens, block by block of its pixels.
struct CollectedLight {
  std::vector<Floats> all;
  std::vector<Floats> mirrored;  ///< share of a view's light that the floor mirrors; none: it is dull
};

/// One image in the making: collects the light of the views that it is exposed to, one after the other.
/// Each view is divided into ever narrower beams until a beam sees only one panel or is a block of pixels.
/// Where a block sees one panel, one ray a pixel is shaded, as patterns are filtered by what a pixel sees of
/// them; where panels meet, samples of a pixel say how much it sees of each. A polished floor shows what the
/// mirrored view sees, besides itself.
class Exposure {
 public:
  /// @param light  to collect in; what is in it is forgotten
  Exposure(const RenderedWorld::Scene& scene, const LensTable& lens, const LightLevels& levels,
           const LaserPlane& laser, CollectedLight& light);

  /// @param samples  of a pixel, where panels meet
  /// @param share    of the exposure's time
  void add(const Viewpoint& view, int samples, float share);

  /// @param exposure  light is multiplied by it before the sensor
  Image develop(const SensorResponse& response, double exposure) const;

 private:
  struct View;

  void look_from(const View& view);
  void look(const View& view, const Square& square, std::vector<Candidate>& candidates, std::size_t begin);
  void add_block(const View& view, std::size_t block, std::span<const Candidate> candidates);
  void add_panel(const View& view, std::size_t block, const SeenPanel& panel, const Coverage& coverage);
  void add_stripe(const ShadedSurface& surface, const RayPacket& rays, const Flags& on_surface,
                  Floats& radiance) const;
  void mirror(const ShadedSurface& surface, const View& view, std::size_t block, const RayPacket& rays,
              const Coverage& coverage, Floats& radiance);

  const RenderedWorld::Scene& scene_;
  const LensTable& lens_;
  LightLevels levels_;
  LaserPlane laser_;
  CollectedLight& light_;
};

}  // namespace aisle
