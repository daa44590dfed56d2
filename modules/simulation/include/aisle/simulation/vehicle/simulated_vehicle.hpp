#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>

#include "aisle/core/random.hpp"
#include "aisle/simulation/moving_bodies.hpp"
#include "aisle/simulation/obstacles.hpp"
#include "aisle/simulation/operators/operator.hpp"
#include "aisle/simulation/scenario_play.hpp"
#include "aisle/simulation/vehicle/range_scanner.hpp"
#include "aisle/simulation/vehicle/vehicle_dynamics.hpp"
#include "aisle/simulation/vehicle/vehicle_model.hpp"
#include "aisle/simulation/vehicle/wheel_odometry.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/truth_source.hpp"
#include "aisle/vehicle/vehicle.hpp"

namespace aisle {

/// The initial pose that a world gives: its start, else its tour's start, facing along it.
std::optional<Pose2> start_pose(const World& world);

class VehicleEyes;

struct SimulationOptions {
  std::uint64_t seed = 1;  ///< of all noise
  Pose2 T_world_start;
  bool takes_images = true;
};

/// Whether a vehicle at this pose touches nothing of the world.
bool fits(const World& world, const Footprint& footprint, const Pose2& T_world_vehicle);

/// A vehicle in a world. Time advances only in sense(), by one cycle per call, in fixed small steps. Each
/// sensor draws its noise from its own stream, so that a fault in one does not change the others.
class SimulatedVehicle final : public Vehicle, public TruthSource {
 public:
  /// @param driver  drives by hand; null: nobody does. Must outlive the vehicle
  SimulatedVehicle(const World& world, const VehicleModel& model, const Scenario& scenario,
                   const SimulationOptions& options, Operator* driver = nullptr);
  ~SimulatedVehicle() override;

  const VehicleDescription& description() const override { return model_.description; }
  std::optional<Observation> sense() override;
  void act(const Command& command) override;

  const Truth& truth() const override { return truth_; }
  /// What moves besides the vehicle.
  std::span<const MovingBody> bodies() const { return bodies_.all(); }

 private:
  void step(double time_s);
  void drive(double time_s);
  void move(const Travel& travel, const Arc& path, double time_s);
  void feel_bumper(double free_share);
  void kidnap_if_due();
  Command commanded() const;
  std::optional<RangeScan> scan();
  OperatorView view();

  VehicleModel model_;
  ScenarioPlay play_;
  Operator* driver_;
  VehicleDynamics dynamics_;
  Random seeds_;  ///< of the streams below
  WheelOdometry odometry_;
  Random slip_random_;
  std::optional<RangeScanner> scanner_;
  Random scanner_random_;
  std::unique_ptr<VehicleEyes> eyes_;
  Obstacles obstacles_;
  MovingBodies bodies_;
  Truth truth_;
  Command command_;
  double command_stamp_s_ = 0;
  std::optional<Pose2> T_world_contact_;  ///< where the bumper was pressed, until the vehicle leaves it
  std::set<std::size_t> lifts_done_;
  long steps_ = 0;
};

}  // namespace aisle
