#pragma once

#include <span>
#include <vector>

#include "aisle/calibration/mount_calibration.hpp"

namespace aisle {

/// Mounts from which a refinement may start: the poses of a camera above the floor that a plane's image
/// allows, at most two, the better one first.
std::vector<CameraMount> mount_starts(std::span<const FloorMark> marks, const CameraModel& lens);

/// Tilt, pan and roll of a rotation. Looking straight down, pan is 0.
CameraMount mount_of(const Mat3& R_vehicle_camera, const Vec3& p_vehicle_camera);

}  // namespace aisle
