#pragma once
/// Vehicle files; see docs/formats/vehicle.md.

#include <filesystem>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/simulation/vehicle/vehicle_model.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Reads a vehicle file; all problems are reported together, each with its line and key. A file without the
/// part `simulated` gets the defaults of that part.
Result<VehicleModel> read_vehicle(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<VehicleModel> parse_vehicle(const std::string& text, const std::string& name);

/// What the vehicle knows about itself, as the text of a vehicle file without the part `simulated`.
std::string vehicle_yaml(const VehicleDescription& vehicle);

/// The complete model, with the part `simulated`.
std::string vehicle_yaml(const VehicleModel& vehicle);

}  // namespace aisle
