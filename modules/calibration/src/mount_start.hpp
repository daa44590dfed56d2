#pragma once

#include <span>
#include <vector>

#include "aisle/calibration/mount_calibration.hpp"

namespace aisle {

/// Mounts from which a refinement may start: the poses of a camera above the floor that a plane's image
/// allows, at most two, the better one first.
std::vector<CameraMount> mount_starts(std::span<const FloorMark> marks, const CameraModel& lens);

}  // namespace aisle
