#pragma once
/// Makes the explorer for missions and for their replays, both from the origin that the session records.

#include <memory>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/exploration/explorer_navigator.hpp"
#include "aisle/missions/exploration/exploring_sensor.hpp"

namespace aisle {

inline constexpr const char* kExplorerNavigator = "explorer";  ///< name of the navigator in a session

/// In which order to explore, and what to see with.
struct ExploringChoice {
  ExploringOrder order = ExploringOrder::kRecommended;
  ExploringSensor sensor = ExploringSensor::kScanner;
  std::string camera = "corridor";  ///< with kMarkers: the camera that sees the laser stripes
};

/// What a session records of it. The caller sets the seed.
SessionOrigin explorer_origin(const ExplorerNavigatorParams& params, const ExploringChoice& choice);

/// Problems: parameters that cannot be read, an unknown order or sensor, a vehicle that lacks the sensor.
Result<std::unique_ptr<ExplorerNavigator>> make_explorer(const SessionOrigin& origin,
                                                         const VehicleDescription& vehicle);

/// What `vehicle` lacks to explore with a sensor; empty: nothing.
Problems check_sensor(ExploringSensor sensor, const std::string& camera, const VehicleDescription& vehicle);

}  // namespace aisle
