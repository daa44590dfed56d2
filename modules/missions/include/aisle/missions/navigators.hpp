#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// The names that make_navigator() knows.
std::vector<std::string> navigator_names();

/// The navigator that `origin` names, with its parameters and seed. An unknown name is a problem that lists
/// the known ones.
Result<std::unique_ptr<Navigator>> make_navigator(const SessionOrigin& origin,
                                                  const VehicleDescription& vehicle);

}  // namespace aisle
