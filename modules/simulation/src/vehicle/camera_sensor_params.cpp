#include "aisle/simulation/vehicle/camera_sensor.hpp"

namespace aisle {

void CameraSensorParams::describe(FieldList& fields) {
  fields.real("exposure", exposure, {0.01, 100},
              "1: white paper under the world's lamps is just not overexposed");
  fields.real("vignetting", vignetting, {0, 1}, "share of light lost in the corners");
  fields.real("noise_sigma", noise_sigma, {0, 100},
              "standard deviation of a mid-grey pixel, in grey levels; grows with brightness as light does");
  fields.real("exposure_time_s", exposure_time_s, {0, 0.1}, "what moves meanwhile is blurred");
  fields.angle("shake_pitch_deg", shake_pitch_rad, {0, 10}, "standard deviation of nodding at 1 m/s");
  fields.angle("shake_roll_deg", shake_roll_rad, {0, 10}, "standard deviation of rolling at 1 m/s");
  fields.real("gamma", gamma, {0.5, 4}, "of the response curve; 1: grey levels are proportional to light");
  fields.count("rays_per_pixel", rays_per_pixel, {1, 64},
               "where surfaces meet; more: smoother edges, slower");
}

}  // namespace aisle
