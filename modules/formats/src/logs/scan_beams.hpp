#pragma once

#include <cstddef>
#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Makes the beams of most scans of each laser those of the laser; scans that have the same lose theirs.
/// Warns of how many keep their own, and where first.
/// @param log  in: every scan has its beams
void settle_beams(LaserLog& log, const std::string& name, Problems& warnings);

/// The number of readings that most scans of the laser have; 0 if it took none.
std::size_t usual_reading_count(const LaserLog& log, std::size_t laser);

}  // namespace aisle
