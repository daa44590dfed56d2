#include "aisle/commands/method.hpp"

#include <fmt/format.h>

namespace aisle {

std::string present_method(const std::string& name) {
  return name == "route" ? kRoomMethod.name : name;
}

std::string present_method(const std::string& name, Console& console) {
  std::string present = present_method(name);
  if (present != name) console.warn(fmt::format("the method '{}' is now '{}'", name, present));
  return present;
}

Result<const Method*> method_named(const std::string& given, Console& console) {
  const std::string name = present_method(given, console);
  std::string names;
  for (const Method* method : {&kLandmarkMethod, &kSectionMethod, &kRoomMethod}) {
    if (method->name == name) return method;
    names += (names.empty() ? "" : ", ") + std::string(method->name);
  }
  return Problem{{"", 0, "--method"}, fmt::format("'{}' is unknown; there are: {}", name, names)};
}

VehicleChoice vehicle_choice(const NavigateOptions& options, const Method& method) {
  return {.connection = options.connection,
          .world = options.world,
          .vehicle = method.vehicle_or_usual(options.vehicle),
          .scenario = options.scenario,
          .seed = options.seed};
}

}  // namespace aisle
