#pragma once

#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

/// Empty if a building can have a route of this name.
/// @param where  where the name comes from, for problems
Problems check_route_name(const Place& where, const std::string& name);

/// "there, back", or "none".
template <class NamedRoute>
std::string names_of(const std::vector<NamedRoute>& routes) {
  std::string names;
  for (const NamedRoute& route : routes) names += (names.empty() ? "" : ", ") + route.name;
  return names.empty() ? "none" : names;
}

/// `asked`; if empty, the name of the building's first route; empty if it has none.
std::string route_name(const Building& building, const std::string& asked);

/// Finds a route by name. An unknown name is a problem that lists the building's routes.
Result<Route> find_route(const Building& building, const std::string& name);

}  // namespace aisle
