#pragma once

#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The shortest time assumed from one message to the next where a clock says nothing.
inline constexpr double kNominalStep_s = 0.1;

/// The repairs that a recorded clock needed.
struct ClockRepair {
  std::size_t places = 0;
  long first_line = 0;
  bool by_motion = false;       ///< times were guessed from the distance driven
  long first_rounded_line = 0;  ///< stamps are rounded, from here on: they were spread evenly; 0: no
};

/// Makes one clock that never goes back of the recorded stamps. They stay as they are where they make sense:
/// good logs keep theirs to the digit.
///
/// Where a stamp steps back, jumps by more than a minute or stands still for long, the usual (median) step is
/// taken, or the time that the vehicle plausibly took for its motion since then if that is longer, and the
/// whole clock is shifted, for scans and odometry alike. If most steps make no sense, all times follow the
/// motion, in file order. Stamps that are rounded (long runs of equal ones,
/// then a plausible step) are spread evenly over each run.
/// @param log  in: stamp_s of the scans, time_s of the odometry are as recorded, lines are set;
///             out: time_s of both are on the mended clock
ClockRepair mend_clock(LaserLog& log);

/// The same; a warning says what was done and where.
void mend_clock(LaserLog& log, const std::string& name, Problems& warnings);

}  // namespace aisle
