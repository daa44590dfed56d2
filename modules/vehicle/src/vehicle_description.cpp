#include "aisle/vehicle/vehicle_description.hpp"

#include <algorithm>

namespace aisle {

void Footprint::describe(FieldList& fields) {
  fields.real("front_m", front_m, {0.01, 10}, "the vehicle's front, ahead of base_link");
  fields.real("rear_m", rear_m, {0, 10}, "the vehicle's rear, behind base_link");
  fields.real("width_m", width_m, {0.01, 10}, "left and right together");
  fields.real("height_m", height_m, {0.01, 5}, "of its highest part");
}

void DriveLimits::describe(FieldList& fields) {
  fields.real("speed_max_mps", speed_max_mps, {0.01, 10}, "forwards");
  fields.real("reverse_speed_max_mps", reverse_speed_max_mps, {0.01, 10}, "backwards");
  fields.real("acceleration_max_mps2", acceleration_max_mps2, {0.01, 20}, "getting faster");
  fields.real("deceleration_max_mps2", deceleration_max_mps2, {0.01, 20}, "braking");
  fields.angle("steering_max_deg", steering_max_rad, {1, 89}, "of the front wheels, either way");
  fields.angle("steering_rate_max_deg_s", steering_rate_max_rad_s, {1, 1000}, "of the front wheels");
  fields.angle("turn_rate_max_deg_s", turn_rate_max_rad_s, {1, 1000}, "of a differential vehicle");
  fields.angle("turn_acceleration_max_deg_s2", turn_acceleration_max_rad_s2, {1, 10000},
               "of a differential vehicle");
  fields.real("command_age_max_s", command_age_max_s, {0.05, 0.5},
              "the vehicle stops when its last command is older");
}

void LaserMarkers::describe(FieldList& fields) {
  fields.real("height_m", height_m, {0.01, 3}, "of the light plane above the floor");
}

const CameraDescription* VehicleDescription::camera(std::string_view called) const {
  const auto found = std::find_if(cameras.begin(), cameras.end(),
                                  [&](const CameraDescription& present) { return present.name == called; });
  return found == cameras.end() ? nullptr : &*found;
}

void VehicleDescription::describe(FieldList& fields) {
  fields.flag("is_differential", is_differential,
              "two wheels with a motor each, instead of steered front wheels");
  fields.group("front_steered", front_steered);
  fields.group("front_steered_noise", front_steered_noise);
  fields.group("differential", differential);
  fields.group("differential_noise", differential_noise);
  fields.group("footprint", footprint);
  fields.group("limits", limits);
  fields.real("cycle_s", cycle_s, {0.01, 2}, "from one observation to the next");
}

}  // namespace aisle
