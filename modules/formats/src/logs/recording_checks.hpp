#pragma once

#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// Looks for what a recording cannot mean, once its clock is mended: another unit of lengths than it is said
/// to have, headings in degrees, poses that jump or are not there, scans that are missing. What is likely is
/// a warning of the recording.
/// @return what is certain; empty: the recording may be used
Problems check_recording(LaserRecording& recording, LengthUnit unit, const std::string& name);

}  // namespace aisle
