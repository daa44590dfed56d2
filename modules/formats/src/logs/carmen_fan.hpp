#pragma once

#include <cstddef>
#include <optional>

namespace aisle {

/// The directions of a scanner's beams: beam 0 and from one beam to the next, counter-clockwise [rad].
struct BeamFan {
  double first_angle_rad = 0;
  double angle_step_rad = 0;
};

/// The fan of a FLASER line with `beams` readings (2 or more).
/// @param resolution_deg  PARAM laser_front_laser_resolution; used where the count alone does not tell
BeamFan flaser_fan(std::size_t beams, std::optional<double> resolution_deg);

}  // namespace aisle
