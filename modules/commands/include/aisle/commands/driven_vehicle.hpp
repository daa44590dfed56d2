#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "aisle/commands/connected_robot.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/commands/simulation_setting.hpp"
#include "aisle/simulation/operators/operator.hpp"
#include "aisle/vehicle/truth_source.hpp"

namespace aisle {

/// Which vehicle a mission drives: a simulated one in a world, or the robot of a connection file.
struct VehicleChoice {
  std::filesystem::path connection;      ///< of a robot; empty: simulated, by what follows
  std::string world, vehicle, scenario;  ///< files or shipped names
  double plan_pixel_m = kPlanPixel_m;
  std::uint64_t seed = 1;
};

/// The vehicle of a mission, wherever it comes from. A simulated one is known before it is set down; a robot
/// stands where it stands.
class DrivenVehicle {
 public:
  /// Reads the setting, or connects to the robot.
  static Result<std::unique_ptr<DrivenVehicle>> open(const VehicleChoice& choice, DrivenBy sensors,
                                                     Console& console);
  static std::unique_ptr<DrivenVehicle> in(SimulationSetting setting, std::uint64_t seed);
  static std::unique_ptr<DrivenVehicle> over(std::unique_ptr<ConnectedRobot> robot);

  /// The setting of a simulated vehicle, whose description may be changed until it is set down; null: it is a
  /// robot.
  SimulationSetting* setting() { return setting_.get(); }
  const VehicleDescription& description() const;

  /// Sets a simulated vehicle down, once. @param person  who drives it; null: nobody. Must outlive it
  void set_down(const Pose2& T_world_start, Operator* person = nullptr, bool takes_images = true);

  /// Of a simulated vehicle after it was set down.
  Vehicle& vehicle();
  const TruthSource* truth() const { return simulated_ ? &*simulated_ : nullptr; }

  /// Who receives what the mission shows: with a robot, its own viewers too.
  MessageSink* watcher(const Console& console) const;

  /// "simulated", with the seed; or with what was counted on the wire.
  void add_to(nlohmann::ordered_json& figures) const;

 private:
  std::uint64_t seed_ = 1;
  std::unique_ptr<SimulationSetting> setting_;
  std::optional<SimulatedVehicle> simulated_;
  std::unique_ptr<ConnectedRobot> robot_;
};

}  // namespace aisle
