#pragma once

#include "aisle/core/problem.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Replaces steps of the odometry that no vehicle makes, as after a restart at zero, by the motion that the
/// scans on both sides show. A step that the scans confirm stays, and one that they cannot tell is taken for
/// no motion.
/// @return one warning a leap, with its line
Problems correct_leaps(LaserLog& log);

}  // namespace aisle
