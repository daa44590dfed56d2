#pragma once

#include <filesystem>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// The scans and the odometry of a bag (bag_reader.hpp). Topics, frames and clocks are chosen as
/// docs/formats/bags.md says, and every choice is a warning. A bag without scans, or without a topic that the
/// options name, is a problem that lists the topics that it has.
Result<LaserRecording> read_laser_bag(const std::filesystem::path& path,
                                      const RecordingOptions& options = {});

}  // namespace aisle
