#pragma once
/// Logs of robots that record what their wheels count, in texts of their own; see
/// docs/formats/counted_logs.md.

#include <span>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// A CoreSLAM log (.dat): one line, one scan of a URG-04LX with the counts of both wheels. Lines that cannot
/// be read are left out with a warning; a log without a scan is a problem.
Result<LaserRecording> parse_coreslam_log(std::string_view text, const std::string& name,
                                          const RecordingOptions& options = {});

/// A log of the Lego robot of Brenner's course: records S (scan) and M (motors), in one text or in several of
/// one run. Without M it has no odometry. Lines that cannot be read are left out with a warning; a log
/// without a scan is a problem.
Result<LaserRecording> parse_lego_log(std::span<const std::string> texts, const std::string& name,
                                      const RecordingOptions& options = {});

/// Whether a text with these first bytes is such a log.
bool begins_coreslam_log(std::string_view head);
bool begins_lego_log(std::string_view head);

/// Whether a text has scans of the Lego robot, not only its motors.
bool has_lego_scans(std::string_view text);

}  // namespace aisle
