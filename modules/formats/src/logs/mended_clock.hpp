#pragma once

#include <span>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// A recorded stamp with the line where it stands.
struct RecordedStamp {
  double stamp_s = 0;
  long line = 0;
};

/// Taken for the usual step of a clock that has none.
inline constexpr double kNominalStep_s = 0.1;

/// What had to be done to a recorded clock.
struct ClockRepair {
  std::size_t places = 0;
  long first_line = 0;
  bool by_nominal_step = false;  ///< the clock stands still or its steps make no sense at all
};

/// Fills in time_s of all scans and odometry samples of `log`: the recorded stamps, except where one steps
/// back, leaps more than a minute or stands still for long. There the usual (median) step is taken instead
/// (kNominalStep_s where that is 0 or there is none) and the whole clock shifted, for scans and odometry
/// alike. One clock for both; neither ever goes back.
/// @param odometry  the stamp of each odometry sample
/// @param scans     the stamp of each scan
ClockRepair mend_clock(LaserLog& log, std::span<const RecordedStamp> scans,
                       std::span<const RecordedStamp> odometry);

}  // namespace aisle
