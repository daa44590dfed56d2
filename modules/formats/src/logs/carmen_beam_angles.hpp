#pragma once

#include <cstddef>
#include <optional>

namespace aisle {

/// The directions of a scanner's beams: of beam 0, and the step from one beam to the next, counter-clockwise
/// [rad].
struct BeamAngles {
  double first_angle_rad = 0;
  double angle_step_rad = 0;
};

/// The beam directions of a FLASER line with `beams` readings (2 or more).
/// @param resolution_deg  PARAM laser_front_laser_resolution; used if the number of readings is ambiguous
BeamAngles flaser_beam_angles(std::size_t beams, std::optional<double> resolution_deg);

}  // namespace aisle
