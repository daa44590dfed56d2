#include "joystick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

double deflection(const ros::Joy& message, int axis) {
  return std::clamp(double{message.axes[static_cast<std::size_t>(axis)]}, -1.0, 1.0);
}

}  // namespace

bool Joystick::is_pressed(const ros::Joy& message, int button) const {
  return button >= 0 && message.buttons[static_cast<std::size_t>(button)] != 0;
}

bool Joystick::take(const ros::Joy& message, double now_s) {
  const int axis = std::max(settings_.speed_axis, settings_.turn_axis);
  const int button = std::max({settings_.dead_man_button, settings_.place_button, settings_.end_button});
  if (std::cmp_greater_equal(axis, message.axes.size()) ||
      std::cmp_greater_equal(button, message.buttons.size()))
    return false;
  if (std::any_of(message.axes.begin(), message.axes.end(), [](float a) { return !std::isfinite(a); }))
    return false;
  const auto begins = [&](int pressed) {
    return is_pressed(message, pressed) && !(latest_ && is_pressed(*latest_, pressed));
  };
  if (begins(settings_.place_button))
    marks_.push_back({Mark::Kind::kPlace, fmt::format("place {}", ++places_)});
  if (begins(settings_.end_button)) {
    marks_.push_back({Mark::Kind::kStop, {}});
    quits_ = true;
  }
  latest_ = message;
  arrived_s_ = now_s;
  return true;
}

OperatorInput Joystick::input(double now_s) {
  OperatorInput input;
  input.marks = std::exchange(marks_, {});
  input.quit = quits_;
  if (!latest_) return input;
  input.requested = Command{};
  if (now_s - arrived_s_ > kSilentMax_s || !is_pressed(*latest_, settings_.dead_man_button)) return input;
  const double turn = deflection(*latest_, settings_.turn_axis);
  input.requested = Command{.speed_mps = deflection(*latest_, settings_.speed_axis) * settings_.speed_mps,
                            .steering_rad = turn * settings_.steering_rad,
                            .turn_rate_rad_s = turn * settings_.turn_rate_rad_s};
  return input;
}

}  // namespace aisle
