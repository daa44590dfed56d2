#pragma once

#include "aisle/vehicle/differential.hpp"
#include "aisle/vehicle/front_steered.hpp"

namespace aisle {

/// What a vehicle is: how it moves and how far its odometry is to be believed.
struct VehicleDescription {
  bool is_differential = false;  ///< else front-steered; the parts of the other kind are not used
  FrontSteered front_steered;
  FrontSteeredNoise front_steered_noise;
  Differential differential;
  DifferentialNoise differential_noise;

  void describe(FieldList& fields);
};

}  // namespace aisle
