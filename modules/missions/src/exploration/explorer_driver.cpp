#include "aisle/missions/exploration/explorer_driver.hpp"

#include <fmt/format.h>

#include <sstream>

#include "aisle/missions/changed_parameters.hpp"

namespace aisle {
namespace {

constexpr const char* kByScanner = "scanner";

}  // namespace

Problems check_sensor(ExploringSensor sensor, const std::string& camera, const VehicleDescription& vehicle) {
  const auto lacks = [&](const std::string& what) {
    return Problems{{{"--vehicle"}, fmt::format("'{}' has no {} to explore with", vehicle.name, what)}};
  };
  if (sensor == ExploringSensor::kScanner) return vehicle.scanner ? Problems{} : lacks("range scanner");
  if (!vehicle.laser_markers) return lacks("laser markers");
  return vehicle.camera(camera) != nullptr ? Problems{} : lacks("camera '" + camera + "'");
}

/// The session's route says how it explores: the order, and the scanner or the camera that sees the stripes.
SessionOrigin explorer_origin(const ExplorerNavigatorParams& params, const ExploringChoice& choice) {
  SessionOrigin origin;
  origin.navigator = kExplorerNavigator;
  origin.parameters = changed_parameters(params);
  origin.route = fmt::format("{} by {}", name_of(choice.order),
                             choice.sensor == ExploringSensor::kScanner ? kByScanner : choice.camera);
  return origin;
}

Result<std::unique_ptr<ExplorerNavigator>> make_explorer(const SessionOrigin& origin,
                                                         const VehicleDescription& vehicle) {
  ExplorerNavigatorParams params;
  if (Problems problems = assign_all(params, origin.parameters); !problems.empty()) return problems;
  std::istringstream words(origin.route);
  std::string order_name, by, eye;
  words >> order_name >> by >> eye;
  const auto order = exploring_order(order_name);
  if (!order || by != "by" || eye.empty())
    return Problem{{"", 0, "route"}, fmt::format("'{}' is not 'ORDER by scanner|CAMERA'", origin.route)};
  const auto sensor = eye == kByScanner ? ExploringSensor::kScanner : ExploringSensor::kMarkers;
  if (Problems problems = check_sensor(sensor, eye, vehicle); !problems.empty()) return problems;
  return std::make_unique<ExplorerNavigator>(
      params, vehicle, *order,
      sensor == ExploringSensor::kScanner ? scanner_scans(vehicle) : marker_scans(vehicle, eye));
}

}  // namespace aisle
