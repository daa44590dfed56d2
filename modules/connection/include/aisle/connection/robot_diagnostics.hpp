#pragma once

#include <memory>
#include <string>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// Tells the robot's own monitors, on /diagnostics, what the vehicle does and why it is held: once a second,
/// and at every change. It stands where a connected vehicle reports its progress.
class RobotDiagnostics final : public Progress {
 public:
  /// All must outlive it.
  RobotDiagnostics(Wire& wire, const Clock& clock, Progress& next);

  /// Whose messages and ages are told from now on; it must outlive what is reported then.
  void watch(const ConnectedVehicle& vehicle) { vehicle_ = &vehicle; }
  /// "held: the emergency stop is pressed", "goes on"
  void note(const std::string& what);

  void report(std::string_view task, std::size_t done, std::size_t total) override;
  bool shall_end() const override { return next_.shall_end(); }

 private:
  void publish();

  const Clock& clock_;
  Progress& next_;
  const ConnectedVehicle* vehicle_ = nullptr;
  std::unique_ptr<WirePublisher> publisher_;  ///< null: it cannot be told
  std::string state_;
  std::string noted_;
  double published_s_;
};

}  // namespace aisle
