#pragma once

#include <vector>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Scanners report "nothing seen" as readings a little below the maximum that they announce (81.87 of 81.92
/// m). Readings of at least this fraction of it mean "nothing seen".
inline constexpr double kUsableShareOfMaximum = 0.97;

/// The smallest reading that means "nothing seen": from the announced maximum or, without one, the largest
/// reading if it occurs repeatedly. Otherwise a value beyond all readings. Infinite readings do not count.
/// @param announced_m  0: none
double find_range_max_m(const std::vector<LaserScan>& scans, double announced_m);

/// The maximum that the readings show where it is less than the announced one: the largest reading, if it is
/// frequent and hardly any others come near it, as walls would make them. Else the announced one.
double believable_maximum_m(const std::vector<LaserScan>& scans, double announced_m);

/// The median of the readings that saw something, of some 500 scans spread over the log; 0 if none did.
/// Readings of more than twice the maximum count too: no scanner reports "nothing seen" like that, so the
/// unit must be wrong.
double median_reading_m(const LaserLog& log);

}  // namespace aisle
