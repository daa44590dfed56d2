#pragma once

#include <span>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// A recorded stamp with its line number.
struct RecordedStamp {
  double stamp_s = 0;
  long line = 0;
};

/// The step assumed for a clock that has no usual one.
inline constexpr double kNominalStep_s = 0.1;

/// The repairs that a recorded clock needed.
struct ClockRepair {
  std::size_t places = 0;
  long first_line = 0;
  bool by_nominal_step = false;  ///< the clock stands still, or none of its steps makes sense
};

/// Fills in time_s of all scans and odometry samples of `log` with the recorded stamps, except where a stamp
/// steps back, jumps by more than a minute or stands still for long. There it takes the usual (median) step
/// (kNominalStep_s if that is 0 or there is none) and shifts the whole clock, for scans and odometry alike:
/// both share one clock, and neither ever goes back.
/// @param scans     the stamp of each scan
/// @param odometry  the stamp of each odometry sample
ClockRepair mend_clock(LaserLog& log, std::span<const RecordedStamp> scans,
                       std::span<const RecordedStamp> odometry);

}  // namespace aisle
