#pragma once

#include <optional>
#include <string>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// What is known of one camera. The intrinsics hold for images of the stated size only.
struct CameraCalibration {
  std::string camera_name = "camera";
  int width_px = 0;   ///< 0: not stated
  int height_px = 0;  ///< 0: not stated
  CameraIntrinsics intrinsics;
  std::optional<double> rms_px;          ///< reprojection error that the intrinsics were found with
  std::optional<CameraMount> mount;      ///< how it sits on the vehicle
  std::optional<double> laser_height_m;  ///< of the vehicle's laser plane above the floor
};

}  // namespace aisle
