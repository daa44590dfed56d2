#pragma once

#include <span>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// What a log leaves open, for its scans to settle.
struct OpenOfLog {
  bool mounting = true;                    ///< nothing says where the scanner sits
  std::span<const ScanBeams> other_beams;  ///< what the beams may be instead, if nothing gives their angles
};

/// What was found in a log.
struct LogFindings {
  Problems warnings;               ///< one a correction, with the line of the recording
  double odometry_delay_s = 0;     ///< that is left, by the turns of the scans; 0 if they do not tell
  bool odometry_by_scans = false;  ///< there was none to use: the log's is now the scans' own motion
};

/// Compares the scans of a log with its odometry, and corrects what they show to be otherwise: readings that
/// run the other way round, other beam angles, a scanner that sits elsewhere by more than 10 cm or 10
/// degrees, odometry on another clock, odometry that is missing or never moves. Each correction is a warning
/// with the line of the recording. A log that agrees with itself stays as it is.
/// @return the warnings; problems if there is no odometry and the scans are too far apart to replace it
Result<LogFindings> correct_log(LaserLog& log, const OpenOfLog& open, Progress& progress);

}  // namespace aisle
