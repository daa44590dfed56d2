#pragma once

#include <string>

#include "aisle/control/path.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// Empty if a vehicle that drives the path meets no barrier of the building, enters no keep-out zone and
/// drives against no one-way zone; else the first place where it does.
/// @param route  name of the route, for problems
Problems check_floor_rules(const Building& building, const std::string& route, const Path& path,
                           const Footprint& footprint);

}  // namespace aisle
