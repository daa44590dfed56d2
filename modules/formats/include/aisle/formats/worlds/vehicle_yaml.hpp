#pragma once
/// Vehicles as files. docs/formats/vehicle.md specifies the format.

#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/simulation/vehicle/vehicle_model.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Reads a vehicle file; all its problems are reported together, each with its line and key. A file without
/// the part `simulated` gets that part's defaults.
Result<VehicleModel> read_vehicle(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in problems.
Result<VehicleModel> parse_vehicle(const std::string& text, const std::string& name);

/// What the vehicle knows of itself, as the text of a vehicle file: nothing of how it really is.
std::string vehicle_yaml(const VehicleDescription& vehicle);

/// All of it.
std::string vehicle_yaml(const VehicleModel& vehicle);

}  // namespace aisle
