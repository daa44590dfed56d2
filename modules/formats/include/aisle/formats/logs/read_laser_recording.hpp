#pragma once

#include <filesystem>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// Reads a recording of a 2-D scanner, whatever its format: CARMEN log, MRPT rawlog, CSV (each plain, gzip or
/// bzip2), ROS bag. The kind is told by content, not by name. A folder that holds exactly one recording is
/// that recording. Anything else is one problem that says what is read and what this looks like.
Result<LaserRecording> read_laser_recording(const std::filesystem::path& path,
                                            const RecordingOptions& options = {});

/// Whether a file or folder is a bag, or a file a log of a 2-D scanner, by its first bytes.
bool is_laser_recording(const std::filesystem::path& path);

}  // namespace aisle
