#pragma once

#include <optional>
#include <vector>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {

/// A run that was interrupted, as its session keeps it.
struct InterruptedRun {
  SessionCycles cycles;
  std::vector<Pose2> T_world_vehicle;  ///< as it was, one a cycle; not empty
};

/// A vehicle on a run that may have been interrupted: first it senses once more what was recorded, so that
/// whoever explores knows again all that it knew, then it goes on in the simulator from where it stood.
class ExplorationRun final : public Vehicle {
 public:
  ExplorationRun(SimulatedVehicle& vehicle, std::optional<InterruptedRun> former)
      : vehicle_(vehicle), former_(std::move(former)), was_interrupted_(former_.has_value()) {}

  const VehicleDescription& description() const override { return vehicle_.description(); }
  /// nullopt also where the session cannot be read any farther: then problems() says why.
  std::optional<Observation> sense() override;
  void act(const Command& command) override;

  bool was_interrupted() const { return was_interrupted_; }
  /// Where the vehicle really is, or was.
  const Pose2& T_world_vehicle() const;
  double path_m() const { return former_path_m_ + vehicle_.truth().path_m; }
  const Problems& problems() const { return problems_; }

 private:
  std::optional<Observation> sense_again();

  SimulatedVehicle& vehicle_;
  std::optional<InterruptedRun> former_;  ///< none any more when all of it was sensed again
  bool was_interrupted_;
  std::size_t sensed_ = 0;  ///< cycles of it
  double former_s_ = 0;     ///< when it ended
  double former_path_m_ = 0;
  Problems problems_;
};

}  // namespace aisle
