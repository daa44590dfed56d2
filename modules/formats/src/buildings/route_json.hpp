#pragma once
/// The part "routes" of a building.

#include <string>
#include <vector>

#include "aisle/maps/route.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string routes_json(const std::vector<Route>& routes);

/// Empty and duplicate names are problems, and so are routes that lead nowhere.
std::vector<Route> read_routes(const JsonValue& value);

}  // namespace aisle
