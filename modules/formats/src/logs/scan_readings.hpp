#pragma once

#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "logs/occurrences.hpp"

namespace aisle {

/// Readings that are not distances, as drivers write them (REP 117): counted while a recording is read.
struct ReadingCounts {
  Occurrences void_readings;  ///< NaN, minus infinity, negative or absurd: the beam tells nothing
  Occurrences beyond_range;   ///< plus infinity: nothing is in range

  /// The reading as it is kept until the scanner's range is known: 0 tells nothing, infinity is out of range.
  float kept(double reading_m, long line);
  void warn(const std::string& name, Problems& warnings) const;
};

/// Puts infinite readings just at what means "nothing seen".
void replace_infinite_readings(LaserLog& log);

/// Turns a scan that was taken clockwise, or by a scanner that hangs upside down: beams and readings.
void make_counter_clockwise(LaserScan& scan);

}  // namespace aisle
