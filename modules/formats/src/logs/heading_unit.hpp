#pragma once

#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// Whether headings that are said to be radians are degrees: a vehicle drives where it heads, forwards or in
/// reverse. A problem where the path says so; a warning where only some turns are too fast.
void check_heading_unit(LaserRecording& recording, const std::string& name, Problems& problems);

}  // namespace aisle
