#include "rooms/room_driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "aisle/formats/building_json.hpp"
#include "aisle/guidance/room_cameras.hpp"
#include "changed_parameters.hpp"
#include "route_name.hpp"

namespace aisle {
namespace {

std::vector<std::string> cameras_needed(ParkingStrategy parking) {
  if (parking == ParkingStrategy::kFrame) return {kFirstCamera, kSecondCamera, kThirdCamera};
  return {kFirstCamera};
}

}  // namespace

Result<Route> find_room_route(const Building& building, const std::string& name) {
  const bool is_first = name.empty() && !building.routes.empty();
  auto route = find_route(building, is_first ? building.routes.front().name : name);
  if (route && !route->room) {
    return Problem{{"", 0, "route"}, fmt::format("'{}' was not taught as a way through a room", route->name)};
  }
  return route;
}

void keep_room_cameras(VehicleDescription& vehicle, ParkingStrategy parking) {
  const std::vector<std::string> needed = cameras_needed(parking);
  std::erase_if(vehicle.cameras, [&](const CameraDescription& camera) {
    return std::find(needed.begin(), needed.end(), camera.name) == needed.end();
  });
}

Problems unfit_for_rooms(const VehicleDescription& vehicle, ParkingStrategy parking) {
  Problems problems;
  if (vehicle.is_differential)
    problems.push_back(
        {{"", 0, "is_differential"}, "is true: ways through rooms need a front-steered vehicle"});
  for (const std::string& name : cameras_needed(parking)) {
    if (vehicle.camera(name) == nullptr)
      problems.push_back({{"", 0, "cameras"}, fmt::format("lack '{}', which looks at the route", name)});
  }
  return problems;
}

Result<std::unique_ptr<RoomNavigator>> make_room_navigator(const SessionOrigin& origin,
                                                           const VehicleDescription& vehicle) {
  auto building = parse_building(origin.building, "building");
  if (!building) return building.problems();
  RoomDriverParams params;
  Problems problems = assign_all(params, origin.parameters);
  auto route = find_room_route(*building, origin.route);
  if (!route) {
    problems.insert(problems.end(), route.problems().begin(), route.problems().end());
    return problems;
  }
  for (Problem& problem : unfit_for_rooms(vehicle, route->room->parking))
    problems.push_back(std::move(problem));
  for (Problem& problem : check_barriers(*building, route->name, route->path, vehicle.footprint))
    problems.push_back(std::move(problem));
  if (!problems.empty()) return problems;
  return std::make_unique<RoomNavigator>(params.navigator, vehicle, std::move(*route), params.from_m);
}

}  // namespace aisle
