#include "aisle/commands/navigators.hpp"

#include <fmt/format.h>

#include "aisle/guidance/hand_driver.hpp"

namespace aisle {
namespace {

struct Entry {
  const char* name;
  Result<std::unique_ptr<Navigator>> (*make)(const SessionOrigin&, const VehicleDescription&);
};

Result<std::unique_ptr<Navigator>> make_hand_driver(const SessionOrigin& origin, const VehicleDescription&) {
  HandDriverParams params;
  FieldList fields = fields_of(params);
  Problems problems;
  for (const auto& [key, value] : origin.parameters) {
    const Problems wrong = fields.assign(key, value, {"", 0, key});
    problems.insert(problems.end(), wrong.begin(), wrong.end());
  }
  if (!problems.empty()) return problems;
  return std::unique_ptr<Navigator>(std::make_unique<HandDriver>(params));
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {{"hand", make_hand_driver}};
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
