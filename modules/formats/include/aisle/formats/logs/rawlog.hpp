#pragma once
/// MRPT's rawlogs, of both kinds: observations, and actions with sensory frames; see docs/formats/rawlog.md.

#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// The scans of all level scanners, with the odometry. Objects of other classes are skipped with a warning, a
/// file that is cut off gives what is whole. `line` of a scan or pose is the number of its object. A class
/// that is needed in an unknown version, and a file without a scan, are problems.
/// @param bytes  unpacked
Result<LaserRecording> parse_rawlog(std::string_view bytes, const std::string& name,
                                    const RecordingOptions& options = {});

}  // namespace aisle
