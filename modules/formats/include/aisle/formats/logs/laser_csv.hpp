#pragma once
/// Scans and odometry as a table, as people write it with pandas; see docs/formats/laser_csv.md.

#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// One row, one scan with the odometry's pose; rows without readings are odometry alone. The names of the
/// columns carry their units, whatever the options say. Rows that cannot be read are problems with line and
/// column; a last row that is cut off is left out with a warning.
Result<LaserRecording> parse_laser_csv(std::string_view text, const std::string& name,
                                       const RecordingOptions& options = {});

}  // namespace aisle
