#include "aisle/commands/methods.hpp"

#include <fmt/format.h>

namespace aisle {

Problems check_method(const std::string& method) {
  if (method == "landmarks" || method == "sections" || method == "route") return {};
  return {
      {{"", 0, "--method"}, fmt::format("'{}' is unknown; there are: landmarks, sections, route", method)}};
}

std::string vehicle_or_usual(const std::string& vehicle, const std::string& method) {
  if (!vehicle.empty()) return vehicle;
  return method == "sections" ? "mini" : "alv";
}

}  // namespace aisle
