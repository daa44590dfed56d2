#include "aisle/commands/driven_vehicle.hpp"

#include <utility>

namespace aisle {

Result<std::unique_ptr<DrivenVehicle>> DrivenVehicle::open(const VehicleChoice& choice, DrivenBy sensors,
                                                           Console& console) {
  if (!choice.connection.empty()) {
    auto robot = connect_robot(choice.connection, sensors, console);
    if (!robot) return robot.problems();
    return over(std::move(*robot));
  }
  auto setting = read_setting(choice.world, choice.vehicle, choice.scenario, choice.plan_pixel_m);
  if (!setting) return setting.problems();
  for (const std::string& warning : setting->warnings) console.warn(warning);
  return in(std::move(*setting), choice.seed);
}

std::unique_ptr<DrivenVehicle> DrivenVehicle::in(SimulationSetting setting, std::uint64_t seed) {
  auto driven = std::make_unique<DrivenVehicle>();
  driven->setting_ = std::make_unique<SimulationSetting>(std::move(setting));
  driven->seed_ = seed;
  return driven;
}

std::unique_ptr<DrivenVehicle> DrivenVehicle::over(std::unique_ptr<ConnectedRobot> robot) {
  auto driven = std::make_unique<DrivenVehicle>();
  driven->robot_ = std::move(robot);
  return driven;
}

const VehicleDescription& DrivenVehicle::description() const {
  return robot_ ? robot_->vehicle->description() : setting_->vehicle.description;
}

void DrivenVehicle::set_down(const Pose2& T_world_start, Operator* person, bool takes_images) {
  simulated_.emplace(
      setting_->world, setting_->vehicle, setting_->scenario,
      SimulationOptions{.seed = seed_, .T_world_start = T_world_start, .takes_images = takes_images}, person);
}

Vehicle& DrivenVehicle::vehicle() {
  if (robot_) return *robot_->vehicle;
  return *simulated_;
}

MessageSink* DrivenVehicle::watcher(const Console& console) const {
  return robot_ ? robot_->viewer.get() : console.watcher;
}

void DrivenVehicle::add_to(nlohmann::ordered_json& figures) const {
  figures["simulated"] = is_simulated(truth());
  if (robot_) {
    figures["connection"] = counts_json(robot_->vehicle->counts());
  } else {
    figures["seed"] = seed_;
  }
}

}  // namespace aisle
