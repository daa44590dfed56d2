#pragma once

#include <optional>
#include <string>

#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// The one port to the world. The simulator, a recorded session and a real robot implement it; nothing above
/// can tell which one it has.
class Vehicle {
 public:
  virtual ~Vehicle() = default;

  virtual const VehicleDescription& description() const = 0;

  /// Waits for the next cycle.
  /// @return nullopt if there is no next cycle: the recording ended, the connection is lost
  virtual std::optional<Observation> sense() = 0;

  /// Why sense() returned nullopt, as one line for people: "the recording ended". Empty before, and for a
  /// vehicle that never ends.
  virtual std::string end_reason() const { return {}; }

  /// Takes effect at once and until the next command, or until it is too old. A value that is not finite
  /// means: stop.
  virtual void act(const Command& command) = 0;
};

}  // namespace aisle
