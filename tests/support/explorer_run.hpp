#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/missions/exploration/explorer_driver.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {

/// A world within one closed wall, whose free side is on its left.
inline World walled_by(std::initializer_list<Vec2> corners, const Pose2& T_world_start) {
  World world;
  const Vec2* from = corners.end() - 1;
  for (const Vec2& to : corners) {
    world.walls.push_back({.floor_edge = {*from, to}});
    from = &to;
  }
  world.start = T_world_start;
  return world;
}

/// A shipped vehicle without its cameras.
inline VehicleModel shipped_explorer(const std::string& name) {
  auto read = read_vehicle(std::filesystem::path(AISLE_SOURCE_DIR) / "vehicles" / (name + ".yaml"));
  if (!read) throw std::runtime_error(to_string(read.problems()));
  read->description.cameras.clear();
  return *read;
}

inline VehicleModel cart_with_scanner() {
  return shipped_explorer("alv-scanner");
}

/// An explorer with a range scanner in a world, driven cycle by cycle.
class ExplorerRun {
 public:
  ExplorerRun(const World& world, std::uint64_t seed, const ExplorerNavigatorParams& params = {},
              const std::string& name = "alv-scanner")
      : vehicle(world, shipped_explorer(name), {}, {.seed = seed, .T_world_start = *world.start}),
        T_world_start_(*world.start) {
    auto made = make_explorer(explorer_origin(params, {}), vehicle.description());
    if (!made) throw std::runtime_error(to_string(made.problems()));
    explorer = std::move(*made);
  }

  bool goes_on(double time_max_s) const {
    return last.status == NavigatorStatus::kGoing && vehicle.truth().stamp_s < time_max_s;
  }
  void step(const Observation& observation) {
    last = explorer->step(observation);
    vehicle.act(last.command);
  }
  void step() { step(*vehicle.sense()); }
  double off_home_m() const {
    return (vehicle.truth().T_world_vehicle.position() - T_world_start_.position()).norm();
  }

  SimulatedVehicle vehicle;
  std::unique_ptr<ExplorerNavigator> explorer;
  Decision last;

 private:
  Pose2 T_world_start_;
};

}  // namespace aisle
