#pragma once

#include <optional>
#include <utility>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// A session in the place of a vehicle: it senses what was recorded, and goes where it went.
class RecordedVehicle final : public Vehicle {
 public:
  explicit RecordedVehicle(SessionCycles cycles) : cycles_(std::move(cycles)) {}

  const VehicleDescription& description() const override { return cycles_.vehicle(); }

  /// nullopt also where the session cannot be read any farther: then problems() says why.
  std::optional<Observation> sense() override;
  void act(const Command& /*command*/) override {}

  /// What was decided on the observation sensed last.
  const std::optional<Decision>& recorded_decision() const { return decision_; }

  /// Empty if all went well so far.
  const Problems& problems() const { return problems_; }

 private:
  SessionCycles cycles_;
  std::optional<Decision> decision_;
  Problems problems_;
};

}  // namespace aisle
