#pragma once

#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// Empty if a building can have a route of this name.
/// @param where  that gave the name
Problems check_route_name(const Place& where, const std::string& name);

/// "there, back", or "none".
template <class NamedRoute>
std::string names_of(const std::vector<NamedRoute>& routes) {
  std::string names;
  for (const NamedRoute& route : routes) names += (names.empty() ? "" : ", ") + route.name;
  return names.empty() ? "none" : names;
}

/// The name of the route that is asked for; empty: of the building's first, if it has one.
std::string route_name(const Building& building, const std::string& asked);

/// The building's route of that name.
Result<Route> find_route(const Building& building, const std::string& name);

/// Whether the vehicle meets no barrier of the building on the way.
/// @param route  its name
Problems check_barriers(const Building& building, const std::string& route, const Path& path,
                        const Footprint& footprint);

}  // namespace aisle
