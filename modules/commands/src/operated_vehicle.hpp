#pragma once

#include <optional>
#include <string>

#include "aisle/simulation/operators/operator.hpp"
#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// A vehicle with a person at its controls, who sees of it what the odometry says. What the vehicle itself
/// reports of its operator (a joystick) stays.
class OperatedVehicle final : public Vehicle {
 public:
  /// Both must outlive it. @param person  null: nobody
  OperatedVehicle(Vehicle& vehicle, Operator* person) : vehicle_(vehicle), person_(person) {}

  const VehicleDescription& description() const override { return vehicle_.description(); }
  std::optional<Observation> sense() override;
  std::string end_reason() const override { return vehicle_.end_reason(); }
  void act(const Command& command) override { vehicle_.act(command); }

 private:
  Vehicle& vehicle_;
  Operator* person_;
  OperatorView view_;
};

}  // namespace aisle
