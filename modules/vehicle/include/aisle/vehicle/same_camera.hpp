#pragma once

#include "aisle/core/problem.hpp"
#include "aisle/vehicle/camera_description.hpp"

namespace aisle {

/// Whether what was learned through one camera can be used through another: name and image size the same,
/// focal lengths within 0.5 %, optical axis within 0.5 px, distortion within 0.5 px all over the image,
/// mount within 5 mm and 0.2 degrees. The frame rate does not matter.
/// @return one problem for each thing that differs, its key as in the vehicle's file ("cameras.front.fx_px")
Problems check_same_camera(const CameraDescription& learned, const CameraDescription& present);

}  // namespace aisle
