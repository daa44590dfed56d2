#include "rendering/lens_table.hpp"

#include <tbb/parallel_for.h>

namespace aisle {

LensTable::LensTable(const CameraDescription& camera, double vignetting)
    : width_px(camera.width_px),
      height_px(camera.height_px),
      slopes(index(0, height_px)),
      transmission(slopes.size(), 0) {
  const CameraModel model(camera.intrinsics);
  const Vec2 middle{(width_px - 1) / 2.0, (height_px - 1) / 2.0};
  tbb::parallel_for(0, height_px, [&](int v) {
    for (int u = 0; u < width_px; ++u) {
      const Vec2 pixel{u, v};
      const auto ray = model.ray(pixel);
      if (!ray) continue;
      slopes[index(u, v)] = {
          static_cast<float>(ray->direction.x()),  static_cast<float>(ray->direction.y()),
          static_cast<float>(ray->by_pixel(0, 0)), static_cast<float>(ray->by_pixel(0, 1)),
          static_cast<float>(ray->by_pixel(1, 0)), static_cast<float>(ray->by_pixel(1, 1))};
      const double from_middle = (pixel - middle).squaredNorm() / middle.squaredNorm();
      transmission[index(u, v)] = static_cast<float>(1 - vignetting * from_middle);
    }
  });
}

}  // namespace aisle
