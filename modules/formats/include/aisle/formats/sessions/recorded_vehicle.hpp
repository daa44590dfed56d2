#pragma once

#include <optional>
#include <string>
#include <utility>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// A session that plays a vehicle: it returns the recorded observations and goes where the recorded vehicle
/// went.
class RecordedVehicle final : public Vehicle {
 public:
  explicit RecordedVehicle(SessionCycles cycles) : cycles_(std::move(cycles)) {}

  const VehicleDescription& description() const override { return cycles_.vehicle(); }

  /// nullopt also if the session cannot be read any further; problems() then says why.
  std::optional<Observation> sense() override;
  std::string end_reason() const override {
    return problems_.empty() ? "the recording ended" : to_string(problems_.front());
  }
  void act(const Command& /*command*/) override {}

  /// The decision that was recorded for the latest observation.
  const std::optional<Decision>& recorded_decision() const { return decision_; }

  /// Empty if all went well so far.
  const Problems& problems() const { return problems_; }

 private:
  SessionCycles cycles_;
  std::optional<Decision> decision_;
  Problems problems_;
};

}  // namespace aisle
