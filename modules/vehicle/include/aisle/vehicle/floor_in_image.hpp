#pragma once

#include "aisle/geometry/camera_model.hpp"
#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

/// The part of the floor in a camera's field of view, as if nothing hid it.
class FloorInImage {
 public:
  explicit FloorInImage(const CameraDescription& camera);

  /// @param p_vehicle  on the floor, in base_link
  bool shows(const Vec2& p_vehicle) const;

  /// Floor nearer ahead than this is below the image in some of its columns; 0: the camera looks above the
  /// floor.
  double nearest_m() const { return nearest_m_; }

 private:
  CameraDescription camera_;
  CameraModel model_;
  double nearest_m_ = 0;
};

}  // namespace aisle
