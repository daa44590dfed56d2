#include "aisle/simulation/vehicle/wheel_odometry.hpp"

#include <cmath>
#include <utility>

namespace aisle {
namespace {

double to_quantum(double value, double quantum) {
  return quantum > 0 ? quantum * std::round(value / quantum) : value;
}

}  // namespace

void WheelErrors::describe(FieldList& fields) {
  fields.real("distance_scale", distance_scale, {-0.5, 0.5}, "share of every distance counted too much");
  fields.real("distance_slip_m_per_sqrt_m", distance_slip_m_per_sqrt_m, {0, 1},
              "standard deviation of the distance counted in a metre, grows as the root");
  fields.angle("heading_slip_deg_per_sqrt_m", heading_slip_rad_per_sqrt_m, {0, 20},
               "standard deviation of the turn by sideways slip in a metre, grows as the root");
  fields.angle("steering_bias_deg", steering_bias_rad, {-20, 20},
               "how much farther left than the encoder says the front wheels really point");
  fields.real("distance_quantum_m", distance_quantum_m, {0, 1},
              "front-steered: distances come in multiples of this; 0: not rounded");
  fields.angle("steering_quantum_deg", steering_quantum_rad, {0, 20},
               "front-steered: angles come in multiples of this; 0: not rounded");
  fields.real("wheel_difference", wheel_difference, {-0.5, 0.5},
              "differential: share that the right wheel counts more than the left");
}

WheelOdometry::WheelOdometry(const VehicleDescription& vehicle, const WheelErrors& errors, Random random)
    : vehicle_(vehicle), errors_(errors), random_(random) {}

/// Draws the same number of random numbers whatever happens.
double WheelOdometry::counted_distance_m(double distance_m, double scale, double spin) {
  const double slip_m = random_.normal(errors_.distance_slip_m_per_sqrt_m) * std::sqrt(std::abs(distance_m));
  return distance_m * (1 + scale) * (1 + spin) + slip_m;
}

void WheelOdometry::count(const Travel& travel, double spin) {
  if (vehicle_.is_differential) {
    const double half_turn_m = travel.turn_rad * vehicle_.differential.wheel_separation_m / 2;
    const double half_difference = errors_.wheel_difference / 2;
    left_m_ +=
        counted_distance_m(travel.distance_m - half_turn_m, errors_.distance_scale - half_difference, spin);
    right_m_ +=
        counted_distance_m(travel.distance_m + half_turn_m, errors_.distance_scale + half_difference, spin);
    return;
  }
  distance_m_ += counted_distance_m(travel.distance_m, errors_.distance_scale, spin);
  steering_by_distance_ += travel.steering_rad * std::abs(travel.distance_m);
  travelled_m_ += std::abs(travel.distance_m);
  steering_rad_ = travel.steering_rad;
}

OdometryReading WheelOdometry::read() {
  if (vehicle_.is_differential) return read_steps();
  return read_motion();
}

FrontSteeredMotion WheelOdometry::read_motion() {
  const double steering_rad = travelled_m_ > 0 ? steering_by_distance_ / travelled_m_ : steering_rad_;
  const double counted_m = to_quantum(distance_m_, errors_.distance_quantum_m);
  const double new_m = counted_m - std::exchange(distance_read_m_, counted_m);
  steering_by_distance_ = travelled_m_ = 0;
  return {new_m, to_quantum(steering_rad, errors_.steering_quantum_rad)};
}

WheelSteps WheelOdometry::read_steps() {
  const double step_m = vehicle_.differential.step_length_m();
  const long left = std::lround(left_m_ / step_m), right = std::lround(right_m_ / step_m);
  return {static_cast<int>(left - std::exchange(left_read_, left)),
          static_cast<int>(right - std::exchange(right_read_, right))};
}

}  // namespace aisle
