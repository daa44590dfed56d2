#pragma once

namespace aisle {

/// How to drive until the next command. The vehicle itself keeps the limits of speed, steering and their
/// rates, and stops when no command arrives for DriveLimits::command_age_max_s.
struct Command {
  double speed_mps = 0;        ///< front-steered: of the front reference point; differential: of base_link
  double steering_rad = 0;     ///< front-steered only: left positive
  double turn_rate_rad_s = 0;  ///< differential only: left positive

  friend bool operator==(const Command&, const Command&) = default;
};

}  // namespace aisle
