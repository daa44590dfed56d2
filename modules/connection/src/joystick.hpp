#pragma once

#include <optional>
#include <vector>

#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// What a person asks for by a joystick. The vehicle moves only while the dead-man button is held, and stops
/// when the joystick falls silent: its driver must repeat what it says.
class Joystick {
 public:
  static constexpr double kSilentMax_s = 0.5;

  explicit Joystick(const ConnectedJoystick& settings) : settings_(settings) {}

  /// @return whether the message has the axes and buttons of the settings, as numbers
  bool take(const ros::Joy& message, double now_s);

  /// What was asked for since the last call.
  OperatorInput input(double now_s);

 private:
  bool is_pressed(const ros::Joy& message, int button) const;

  ConnectedJoystick settings_;
  std::optional<ros::Joy> latest_;
  double arrived_s_ = 0;
  std::vector<Mark> marks_;
  bool quits_ = false;
  int places_ = 0;
};

}  // namespace aisle
