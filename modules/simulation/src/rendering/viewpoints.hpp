#pragma once

#include <vector>

#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "rendering/surface.hpp"

namespace aisle {

/// Where the lens is and how it is turned, in the scene's frame.
struct Viewpoint {
  Eigen::Vector3f p_scene_camera;
  Eigen::Matrix3f R_scene_camera;  ///< or a reflection
};

/// What a polished floor shows of it: the same rays, from below.
Viewpoint mirrored_in_floor(const Viewpoint& view);

/// The viewpoints of one exposure, in the order of time: several if what moves is smeared over more than a
/// pixel. Shake is drawn by the seed and the image's number.
std::vector<Viewpoint> viewpoints(const CameraDescription& camera, const CameraSensorParams& params,
                                  const CameraMoment& moment, std::uint64_t seed, const SceneFrame& frame);

}  // namespace aisle
