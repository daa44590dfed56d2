#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/vehicle/truth_source.hpp"
#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// An interrupted run, as its session recorded it.
struct InterruptedRun {
  SessionCycles cycles;
  std::vector<Pose2> T_world_vehicle;  ///< true poses, one per cycle; empty: the vehicle was not simulated
};

/// A vehicle that may continue an interrupted run: it first replays the recorded observations, so that the
/// explorer knows again what it knew, then continues with the vehicle, which stands where the run ended.
class ExplorationRun final : public Vehicle, public TruthSource {
 public:
  /// @param truth   of the vehicle; null: unknown. Both must outlive the run
  /// @param former  with true poses if the vehicle's truth is known
  ExplorationRun(Vehicle& vehicle, const TruthSource* truth, std::optional<InterruptedRun> former)
      : vehicle_(vehicle), known_truth_(truth), former_(std::move(former)) {}

  const VehicleDescription& description() const override { return vehicle_.description(); }
  /// nullopt also if the session cannot be read any further: then problems() says why.
  std::optional<Observation> sense() override;
  std::string end_reason() const override {
    return problems_.empty() ? vehicle_.end_reason() : to_string(problems_.front());
  }
  void act(const Command& command) override;

  /// The truth since the interrupted run began, but for its collisions, which no session records.
  const Truth& truth() const override { return truth_; }
  /// This, or null if the vehicle's truth is unknown.
  const TruthSource* truth_source() const { return known_truth_ == nullptr ? nullptr : this; }

  const Problems& problems() const { return problems_; }

 private:
  std::optional<Observation> sense_again();
  std::optional<Observation> sense_on();

  Vehicle& vehicle_;
  const TruthSource* known_truth_;
  std::optional<InterruptedRun> former_;  ///< reset once all of it has been replayed
  std::size_t sensed_ = 0;                ///< cycles of it that have been replayed
  double former_s_ = 0;                   ///< time stamp of its end
  double former_path_m_ = 0;
  Truth truth_;
  Problems problems_;
};

}  // namespace aisle
