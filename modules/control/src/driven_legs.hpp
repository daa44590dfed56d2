#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {

/// A part of the drive without a direction change: all forwards or all backwards.
struct DrivenLeg {
  Gear gear = Gear::kForward;
  std::vector<Pose2> samples;  ///< base_link, `step_m` apart; at least two
  double turn_before_rad = 0;  ///< on the spot, between the leg before and this one
};

/// The legs of a driven path, thinned to samples a step apart. Less than a step in one direction
/// makes no leg.
std::vector<DrivenLeg> driven_legs(std::span<const Pose2> driven, double step_m);

}  // namespace aisle
