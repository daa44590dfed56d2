#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {

/// An interrupted run, as its session recorded it.
struct InterruptedRun {
  SessionCycles cycles;
  std::vector<Pose2> T_world_vehicle;  ///< true poses, one per cycle; not empty
};

/// A vehicle that may continue an interrupted run: it first replays the recorded observations, so that the
/// explorer knows again what it knew, then continues in the simulator from where the vehicle stood.
class ExplorationRun final : public Vehicle {
 public:
  ExplorationRun(SimulatedVehicle& vehicle, std::optional<InterruptedRun> former)
      : vehicle_(vehicle), former_(std::move(former)), was_interrupted_(former_.has_value()) {}

  const VehicleDescription& description() const override { return vehicle_.description(); }
  /// nullopt also if the session cannot be read any further: then problems() says why.
  std::optional<Observation> sense() override;
  std::string end_reason() const override {
    return problems_.empty() ? vehicle_.end_reason() : to_string(problems_.front());
  }
  void act(const Command& command) override;

  bool was_interrupted() const { return was_interrupted_; }
  /// True pose of the vehicle, recorded while the run is replayed.
  const Pose2& T_world_vehicle() const;
  double path_m() const { return former_path_m_ + vehicle_.truth().path_m; }
  const Problems& problems() const { return problems_; }

 private:
  std::optional<Observation> sense_again();

  SimulatedVehicle& vehicle_;
  std::optional<InterruptedRun> former_;  ///< reset once all of it has been replayed
  bool was_interrupted_;
  std::size_t sensed_ = 0;  ///< cycles of it that have been replayed
  double former_s_ = 0;     ///< time stamp of its end
  double former_path_m_ = 0;
  Problems problems_;
};

}  // namespace aisle
