#include "operated_vehicle.hpp"

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {

std::optional<Observation> OperatedVehicle::sense() {
  auto observation = vehicle_.sense();
  if (!observation || person_ == nullptr) return observation;
  const Pose2 step = odometry_step(description(), observation->odometry);
  const double cycle_s = observation->stamp_s - view_.stamp_s;
  view_ = {.stamp_s = observation->stamp_s,
           .T_world_vehicle = view_.T_world_vehicle * step,
           .speed_mps = cycle_s > 0 ? step.x / cycle_s : 0,
           .turn_rate_rad_s = cycle_s > 0 ? step.theta / cycle_s : 0,
           .free_ahead_m = kSeenAhead_m,
           .bumper_pressed = observation->bumper_pressed};
  OperatorInput input = person_->look(view_);
  OperatorInput& kept = observation->operator_input;
  if (input.requested) kept.requested = input.requested;
  kept.marks.insert(kept.marks.end(), input.marks.begin(), input.marks.end());
  kept.goal_changes.insert(kept.goal_changes.end(), input.goal_changes.begin(), input.goal_changes.end());
  kept.quit |= input.quit;
  kept.gives_up |= input.gives_up;
  return observation;
}

}  // namespace aisle
