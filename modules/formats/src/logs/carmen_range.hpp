#pragma once

#include <vector>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Scanners mark "nothing seen" with readings a little below the maximum that they announce (81.87 of 81.92
/// m). From this share of it on, a reading means nothing seen.
inline constexpr double kUsableShareOfMaximum = 0.97;

/// From where on a reading means nothing seen: by the announced maximum or, where there is none, by the
/// largest reading if it comes again and again. Else beyond all readings.
/// @param announced_m  0: none
double find_range_max_m(const std::vector<LaserScan>& scans, double announced_m);

/// The median of the readings at which something was seen, of some 500 scans spread over the log; 0 if
/// nothing was. Readings of more than twice the maximum count too: no scanner marks "nothing seen" so, the
/// unit must be another.
double median_reading_m(const LaserLog& log);

}  // namespace aisle
