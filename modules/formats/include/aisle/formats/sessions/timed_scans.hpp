#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// A scan of a recording as a session stores it.
struct TimedScan {
  double stamp_s = 0;                        ///< of its middle reading; 0 to 2^31
  RangeScan scan;                            ///< its stamp is that of the reading measured first
  double reading_period_s = 0;               ///< as ScanBeams::period_s
  std::optional<Pose2> T_odom_vehicle = {};  ///< by the wheels; in every scan of a log with odometry
};

struct TimedScans {
  LaserScanner scanner;          ///< of all scans, within what a vehicle file may say
  std::vector<TimedScan> scans;  ///< each at least a microsecond later than the one before
  std::size_t left_out = 0;
};

/// The scans of a log's first scanner. A session knows one scanner: scans with other beams than the first are
/// given its beams, each with the reading next to it. What is left out or changed is a warning.
/// @param file  the recording, for warnings
TimedScans timed_scans(LaserLog log, const std::string& file, Problems& warnings);

}  // namespace aisle
