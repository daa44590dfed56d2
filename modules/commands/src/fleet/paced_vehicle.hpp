#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// A simulated vehicle whose time passes as fast as the others': who talks with it lives in real time.
class PacedVehicle final : public Vehicle {
 public:
  /// @param vehicle  must outlive it
  /// @param rate  simulated seconds per second
  PacedVehicle(Vehicle& vehicle, double rate) : vehicle_(vehicle), rate_(rate) {}

  const VehicleDescription& description() const override { return vehicle_.description(); }
  std::optional<Observation> sense() override;
  std::string end_reason() const override { return vehicle_.end_reason(); }
  void act(const Command& command) override { vehicle_.act(command); }

 private:
  Vehicle& vehicle_;
  double rate_;
  std::optional<double> stamp_s_;  ///< of the last observation
  std::chrono::steady_clock::time_point due_;
};

}  // namespace aisle
