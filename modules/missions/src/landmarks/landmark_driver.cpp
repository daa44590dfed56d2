#include "aisle/missions/landmarks/landmark_driver.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "aisle/missions/route_name.hpp"
#include "aisle/missions/route_rules.hpp"
#include "aisle/vehicle/same_camera.hpp"

namespace aisle {
namespace {

void append(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

/// Checks that the vehicle has the camera that the landmarks were seen with.
Problems check_camera(const CameraDescription& learned, const VehicleDescription& vehicle) {
  if (const CameraDescription* present = vehicle.camera(learned.name))
    return check_same_camera(learned, *present);
  return {{{"", 0, "cameras." + learned.name}, "is missing: the building's landmarks were seen with it"}};
}

Problems check_building(const Building& building, const VehicleDescription& vehicle) {
  if (building.landmarks.empty())
    return {{{"", 0, "landmarks"}, "are missing: the building was not learned by them"}};
  return check_camera(*building.camera, vehicle);
}

Result<Path> find_path(const Building& building, const SessionOrigin& origin, const Footprint& footprint) {
  auto route = find_route(building, origin.route);
  if (!route) return route.problems();
  if (!origin.in_reverse) return std::move(route->path);
  Path back = path_back(route->path, footprint);
  if (back.empty())
    return Problem{{"", 0, "route"}, fmt::format("'{}' is too short for a return path", route->name)};
  return back;
}

}  // namespace

SessionOrigin LandmarkDriver::origin(const LandmarkNavigatorParams& params, const LandmarkMission& mission) {
  SessionOrigin origin;
  origin.navigator = kName;
  origin.parameters = changed_parameters(params);
  origin.building = mission.building;
  origin.route = mission.route;
  origin.in_reverse = mission.in_reverse;
  return origin;
}

Result<std::unique_ptr<LandmarkDriver>> LandmarkDriver::make(const SessionOrigin& origin,
                                                             const VehicleDescription& vehicle) {
  if (origin.building.empty())
    return Problem{{"", 0, "building"}, "is missing: navigator 'landmarks' drives in a learned building"};
  auto building = parse_building(origin.building, "building");
  if (!building) return building.problems();
  LandmarkNavigatorParams params;
  Problems problems = assign_all(params, origin.parameters);
  append(problems, check_building(*building, vehicle));
  auto path = find_path(*building, origin, vehicle.footprint);
  append(problems,
         path ? check_floor_rules(*building, origin.route, *path, vehicle.footprint) : path.problems());
  if (!problems.empty()) return problems;
  return std::make_unique<LandmarkDriver>(params, vehicle, std::move(*building), std::move(*path));
}

LandmarkDriver::LandmarkDriver(const LandmarkNavigatorParams& params, const VehicleDescription& vehicle,
                               Building building, Path path)
    : building_(std::move(building)), path_(std::move(path)), navigator_(params, vehicle, building_, path_) {}

Path path_back(const Path& path, const Footprint& footprint) {
  const double left_m = path.length_m() - (footprint.front_m - footprint.rear_m);
  return left_m > 0 ? path.reversed().up_to(left_m) : Path();
}

}  // namespace aisle
