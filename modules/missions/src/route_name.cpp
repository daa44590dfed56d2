#include "aisle/missions/route_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace aisle {
namespace {

constexpr std::size_t kNameBytesMax = 200;  // as in building files

}  // namespace

Problems check_route_name(const Place& where, const std::string& name) {
  if (name.empty() || name.size() > kNameBytesMax)
    return {
        {where, fmt::format("{} bytes are no name of a route; it has 1 to {}", name.size(), kNameBytesMax)}};
  const auto is_odd = [](char c) { return c == '/' || static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  if (std::any_of(name.begin(), name.end(), is_odd))
    return {{where, "a route's name has neither slashes nor control characters"}};
  return {};
}

std::string route_name(const Building& building, const std::string& asked) {
  return asked.empty() && !building.routes.empty() ? building.routes.front().name : asked;
}

Result<Route> find_route(const Building& building, const std::string& name) {
  for (const Route& route : building.routes) {
    if (route.name == name) return route;
  }
  return Problem{{"", 0, "route"},
                 fmt::format("'{}' is unknown; the building has: {}", name, names_of(building.routes))};
}

}  // namespace aisle
