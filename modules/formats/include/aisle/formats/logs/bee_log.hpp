#pragma once
/// Logs of CMU's course on localisation, which come with a Bee map; see docs/formats/bee.md.

#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// Records L: a scan with the poses of robot and laser, in centimetres. Records O repeat the odometry between
/// scans and are not used. Lines that cannot be read are left out with a warning; a log without a scan is a
/// problem.
Result<LaserRecording> parse_bee_log(std::string_view text, const std::string& name,
                                     const RecordingOptions& options = {});

/// Whether a text with these first bytes is such a log.
bool begins_bee_log(std::string_view head);

}  // namespace aisle
