#pragma once

#include <string>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// A camera as the vehicle knows it: its calibration. What the lens really does is the simulator's business.
struct CameraDescription {
  std::string name = "front";  ///< its images are the topic `/camera/NAME/image_raw`
  int width_px = 640;
  int height_px = 480;
  CameraIntrinsics intrinsics;
  CameraMount mount;
  double period_s = 0.1;  ///< from one image to the next

  void describe(FieldList& fields);
};

}  // namespace aisle
