#include "aisle/missions/rooms/room_driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "aisle/missions/route_name.hpp"
#include "aisle/missions/route_rules.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {
Result<Route> find_room_route(const Building& building, const std::string& name) {
  const bool is_first = name.empty() && !building.routes.empty();
  auto route = find_route(building, is_first ? building.routes.front().name : name);
  if (route && !route->room) {
    return Problem{{"", 0, "route"},
                   fmt::format("'{}' was not taught as a path through a room", route->name)};
  }
  return route;
}

void keep_cameras(VehicleDescription& vehicle, const std::vector<std::string>& names) {
  std::erase_if(vehicle.cameras, [&](const CameraDescription& camera) {
    return std::find(names.begin(), names.end(), camera.name) == names.end();
  });
}

Problems unfit_for_rooms(const VehicleDescription& vehicle, const std::vector<std::string>& cameras) {
  Problems problems;
  if (vehicle.is_differential)
    problems.push_back(
        {{"", 0, "is_differential"}, "is true: paths through rooms need a front-steered vehicle"});
  for (const std::string& name : cameras) {
    const CameraDescription* camera = vehicle.camera(name);
    if (camera == nullptr) {
      problems.push_back({{"", 0, "cameras"}, fmt::format("lack '{}', which looks at the route", name)});
      continue;
    }
    if (!RouteView::sees_floor(camera->intrinsics, camera->mount, camera->width_px, camera->height_px))
      problems.push_back(
          {{"", 0, fmt::format("cameras.{}", name)},
           "does not see the floor in the middle of its lowest row: it must look down at the route"});
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
  for (Problem& problem : unfit_for_rooms(vehicle, cameras_for(*route)))
    problems.push_back(std::move(problem));
  for (Problem& problem : check_floor_rules(*building, route->name, route->path, vehicle.footprint))
    problems.push_back(std::move(problem));
  if (!problems.empty()) return problems;
  return std::make_unique<RoomNavigator>(params.navigator, vehicle, std::move(*route), params.from_m,
                                         FloorRules(*building, vehicle));
}

}  // namespace aisle
