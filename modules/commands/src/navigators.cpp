#include "aisle/commands/navigators.hpp"

#include <fmt/format.h>

namespace aisle {
namespace {

struct Entry {
  const char* name;
  Result<std::unique_ptr<Navigator>> (*make)(const SessionOrigin&, const VehicleDescription&);
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {};
  return all;
}

}  // namespace

std::vector<std::string> navigator_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries()) names.emplace_back(entry.name);
  return names;
}

Result<std::unique_ptr<Navigator>> make_navigator(const SessionOrigin& origin,
                                                  const VehicleDescription& vehicle) {
  for (const Entry& entry : entries()) {
    if (entry.name == origin.navigator) return entry.make(origin, vehicle);
  }
  return Problem{
      {"", 0, "navigator"},
      fmt::format("'{}' is unknown; there are: {}", origin.navigator, fmt::join(navigator_names(), ", "))};
}

}  // namespace aisle
