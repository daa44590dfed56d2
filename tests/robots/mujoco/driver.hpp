#pragma once

#include <optional>

#include "physics.hpp"
#include "vehicle.hpp"

namespace robots {

/// What the robot is asked to do, by whatever message.
struct Command {
  double speed_mps = 0;  ///< of base_link
  double turn_rate_radps = 0;
  std::optional<double> steering_rad;  ///< instead of the turn rate
  double given_s = 0;                  ///< on the robot's clock
};

/// What the robot believes of its wheels.
struct Calibration {
  double left_radius_m = 0;
  double right_radius_m = 0;
  double separation_m = 0;
};

/// Turns commands into motor targets, as a real robot's driver does: within the vehicle's limits, and for no
/// longer than half a second after the last command.
class Driver {
 public:
  Driver(const Vehicle& vehicle, const Calibration& calibration)
      : vehicle_(vehicle), calibration_(calibration) {}

  /// What is not finite, or was given before the last command, is ignored.
  void take(const Command& command);
  /// @param duration_s for which the targets will be held: steering moves no faster than its motor
  MotorTargets targets(double now_s, double duration_s);

  bool is_fresh(double now_s) const;
  /// That is driven at present: zero without a fresh command.
  double speed_mps() const { return speed_mps_; }

 private:
  double turn_rate(const Command& command, double duration_s);
  void steer(const Command& command, double duration_s);

  Vehicle vehicle_;
  Calibration calibration_;
  std::optional<Command> last_;
  double speed_mps_ = 0;
  double steering_rad_ = 0;
};

}  // namespace robots
