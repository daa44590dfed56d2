#include "aisle/guidance/hand_driver.hpp"

#include <algorithm>

namespace aisle {

void HandDriverParams::describe(FieldList& fields) {
  fields.real("speed_max_mps", speed_max_mps, {0.01, 10}, "forwards, whatever is requested");
  fields.real("reverse_speed_max_mps", reverse_speed_max_mps, {0.01, 10}, "backwards");
  fields.angle("steering_max_deg", steering_max_rad, {1, 89}, "of the front wheels, either way");
  fields.angle("turn_rate_max_deg_s", turn_rate_max_rad_s, {1, 1000}, "of a differential vehicle");
  fields.real("request_age_max_s", request_age_max_s, {0.05, 10},
              "when the last request is older, the vehicle stops");
}

Command HandDriver::limited(const Command& requested) const {
  return {std::clamp(requested.speed_mps, -params_.reverse_speed_max_mps, params_.speed_max_mps),
          std::clamp(requested.steering_rad, -params_.steering_max_rad, params_.steering_max_rad),
          std::clamp(requested.turn_rate_rad_s, -params_.turn_rate_max_rad_s, params_.turn_rate_max_rad_s)};
}

Decision HandDriver::step(const Observation& observation) {
  const OperatorInput& input = observation.operator_input;
  if (observation.bumper_pressed) {
    return {.status = NavigatorStatus::kFailed, .state = "bumped", .why = "the vehicle touches something"};
  }
  if (input.gives_up) {
    return {.status = NavigatorStatus::kFailed, .state = "given up", .why = "the operator gave up"};
  }
  if (input.quit) return {.status = NavigatorStatus::kDone, .state = "ended", .why = "ended by hand"};
  if (input.requested) {
    requested_ = limited(*input.requested);
    request_stamp_s_ = observation.stamp_s;
  }
  if (!request_stamp_s_) return {.state = "waiting", .why = "no request so far"};
  if (observation.stamp_s - *request_stamp_s_ > params_.request_age_max_s) {
    return {.state = "waiting", .why = "requests have stopped coming"};
  }
  return {.command = requested_, .state = "driving"};
}

}  // namespace aisle
