#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/simulation/scenario.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "aisle/simulation/vehicle/vehicle_model.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// World, vehicle and faults of a simulated mission, read and checked.
struct SimulationSetting {
  std::filesystem::path world_file;
  World world;
  VehicleModel vehicle;
  Scenario scenario;
  std::vector<std::string> warnings;  ///< of making the world from a plan
};

inline constexpr double kPlanPixel_m = 0.05;

/// Reads a setting from files or shipped names; empty: no world, no scenario. The world may also be any plan
/// that `aisle convert` reads.
/// @param plan_pixel_m  side of a plan's pixel, unless its file gives it
Result<SimulationSetting> read_setting(const std::string& world, const std::string& vehicle,
                                       const std::string& scenario, double plan_pixel_m = kPlanPixel_m);

/// The world's start pose; a problem if the vehicle does not fit there.
Result<Pose2> start_in(const SimulationSetting& setting);

/// The setting's vehicle in its world, with the scenario's faults. The setting must outlive it.
SimulatedVehicle vehicle_in(const SimulationSetting& setting, const Pose2& T_world_start, std::uint64_t seed);

}  // namespace aisle
