#include "aisle/missions/navigators.hpp"

#include <fmt/format.h>

#include "aisle/guidance/hand_driver.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "aisle/missions/exploration/explorer_driver.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"
#include "aisle/missions/landmarks/landmark_driver.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/missions/sections/section_driver.hpp"

namespace aisle {
namespace {

struct Entry {
  const char* name;
  Result<std::unique_ptr<Navigator>> (*make)(const SessionOrigin&, const VehicleDescription&);
};

Result<std::unique_ptr<Navigator>> make_hand_driver(const SessionOrigin& origin, const VehicleDescription&) {
  HandDriverParams params;
  if (Problems problems = assign_all(params, origin.parameters); !problems.empty()) return problems;
  return std::unique_ptr<Navigator>(std::make_unique<HandDriver>(params));
}

Result<std::unique_ptr<Navigator>> make_landmark_navigator(const SessionOrigin& origin,
                                                           const VehicleDescription& vehicle) {
  auto driver = LandmarkDriver::make(origin, vehicle);
  if (!driver) return driver.problems();
  return std::unique_ptr<Navigator>(std::move(*driver));
}

Result<std::unique_ptr<Navigator>> make_guide_navigator(const SessionOrigin& origin,
                                                        const VehicleDescription& vehicle) {
  auto driver = GuideDriver::make(origin, vehicle);
  if (!driver) return driver.problems();
  return std::unique_ptr<Navigator>(std::move(*driver));
}

Result<std::unique_ptr<Navigator>> make_by_sections(const SessionOrigin& origin,
                                                    const VehicleDescription& vehicle) {
  auto navigator = make_section_navigator(origin, vehicle);
  if (!navigator) return navigator.problems();
  return std::unique_ptr<Navigator>(std::move(*navigator));
}

Result<std::unique_ptr<Navigator>> make_through_room(const SessionOrigin& origin,
                                                     const VehicleDescription& vehicle) {
  auto navigator = make_room_navigator(origin, vehicle);
  if (!navigator) return navigator.problems();
  return std::unique_ptr<Navigator>(std::move(*navigator));
}

Result<std::unique_ptr<Navigator>> make_exploring(const SessionOrigin& origin,
                                                  const VehicleDescription& vehicle) {
  auto navigator = make_explorer(origin, vehicle);
  if (!navigator) return navigator.problems();
  return std::unique_ptr<Navigator>(std::move(*navigator));
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {{"hand", make_hand_driver},
                                         {LandmarkDriver::kName, make_landmark_navigator},
                                         {kSectionNavigator, make_by_sections},
                                         {kRoomNavigator, make_through_room},
                                         {GuideDriver::kName, make_guide_navigator},
                                         {kExplorerNavigator, make_exploring}};
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
