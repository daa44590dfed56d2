#pragma once
/// Laser logs in CARMEN's format, one message per line; see docs/formats/carmen.md.

#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/logs/laser_recording.hpp"

namespace aisle {

/// The scans of one scanner in file order, with the odometry. Lines that cannot be read are left out with a
/// warning. Where fewer than half of the scans and poses can be read, each line is a problem with its number;
/// after 20 problems the rest is only counted. read_laser_recording() reads files, packed ones too.
/// @param name  the file name in problems and warnings
Result<LaserRecording> parse_carmen_log(std::string_view text, const std::string& name,
                                        const RecordingOptions& options = {});

/// The scanner that writes FLASER lines with this many readings. A FLASER line contains no angles; they
/// follow from the number of readings, as docs/formats/carmen.md explains.
/// @param beams  2 or more
LaserScanner flaser_scanner(std::size_t beams);

/// The log as PARAM and FLASER lines; reading them gives the same log.
/// @throws std::invalid_argument if FLASER lines cannot express it: every scan needs its own odometry sample
///         (same index, same time), all scans the same number of readings, and the beam angles must be those
///         of flaser_scanner().
std::string carmen_text(const LaserLog& log);

}  // namespace aisle
