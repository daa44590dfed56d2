#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/simulation/scenario.hpp"
#include "aisle/simulation/vehicle/vehicle_model.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// What a simulated mission happens in and with, read and checked.
struct SimulationSetting {
  std::filesystem::path world_file;
  World world;
  VehicleModel vehicle;
  Scenario scenario;
};

inline constexpr double kPlanPixel_m = 0.05;

/// Files or names of shipped ones; empty: no world, no scenario. The world may be any plan that `aisle
/// convert` reads, too.
/// @param plan_pixel_m  side of a plan's pixel where its file does not say it
Result<SimulationSetting> read_setting(const std::string& world, const std::string& vehicle,
                                       const std::string& scenario, double plan_pixel_m = kPlanPixel_m);

/// Where the world says that a vehicle is set down; a problem unless it fits there.
Result<Pose2> start_in(const SimulationSetting& setting);

/// Where a person who sets the vehicle down roughly puts it; exactly there if it would touch something.
Pose2 set_down(const SimulationSetting& setting, const UncertainPose2& T_world_start, std::uint64_t seed);

}  // namespace aisle
