#pragma once

#include <filesystem>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"
#include "aisle/learning/walls/map_building.hpp"

namespace aisle {

/// A log with the warnings about it, as far as the recording and its scans settle it.
struct SettledLog {
  LaserLog log;
  Problems warnings;
  KnownOfLog known;
};

/// Reads a recording and lets its scans settle what it leaves open (docs/explanation/recordings.md).
Result<SettledLog> read_settled_log(const std::filesystem::path& file, const RecordingOptions& reading,
                                    Progress& progress);

/// Reads a recording as it is; a problem if it has no odometry.
Result<SettledLog> read_unsettled_log(const std::filesystem::path& file, const RecordingOptions& reading);

}  // namespace aisle
