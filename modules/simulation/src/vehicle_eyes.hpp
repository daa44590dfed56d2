#pragma once

#include <span>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/simulation/camera_sensor.hpp"
#include "aisle/simulation/scenario_play.hpp"
#include "aisle/simulation/vehicle_model.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// All cameras of a simulated vehicle. They are blind so far.
class VehicleEyes {
 public:
  VehicleEyes(const World&, const VehicleModel&, Random&) {}

  void look(double, const CameraMoment&, std::span<const MovingBody>, const ScenarioPlay&) {}
  std::vector<CameraPicture> deliver(double) { return {}; }
};

}  // namespace aisle
