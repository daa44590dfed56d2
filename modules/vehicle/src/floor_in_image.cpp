#include "aisle/vehicle/floor_in_image.hpp"

#include <algorithm>

#include "aisle/geometry/back_projection.hpp"

namespace aisle {

FloorInImage::FloorInImage(const CameraDescription& camera) : camera_(camera), model_(camera.intrinsics) {
  const BackProjection floor(model_, camera.mount, 0);
  for (int column = 0; column < camera.width_px; ++column) {
    if (const auto p_vehicle = floor.point(Vec2(column, camera.height_px - 1)))
      nearest_m_ = std::max(nearest_m_, p_vehicle->x());
  }
}

bool FloorInImage::shows(const Vec2& p_vehicle) const {
  const auto pixel_px = model_.project(camera_.mount.to_camera({p_vehicle.x(), p_vehicle.y(), 0}));
  return pixel_px && pixel_px->x() >= 0 && pixel_px->x() <= camera_.width_px - 1 && pixel_px->y() >= 0 &&
         pixel_px->y() <= camera_.height_px - 1;
}

}  // namespace aisle
