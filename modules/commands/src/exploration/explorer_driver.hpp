#pragma once
/// Makes the explorer for missions and for their replays, both from the origin that the session records.

#include <memory>
#include <string>

#include "aisle/commands/explore.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/exploration/explorer_navigator.hpp"

namespace aisle {

inline constexpr const char* kExplorerNavigator = "explorer";  ///< name of the navigator in a session

/// What a session records of it. The caller sets seed and "simulated".
SessionOrigin explorer_origin(const ExplorerNavigatorParams& params, const ExploreOptions& options);

/// Problems: parameters that cannot be read, an unknown order or sensor, a vehicle that lacks the sensor.
Result<std::unique_ptr<ExplorerNavigator>> make_explorer(const SessionOrigin& origin,
                                                         const VehicleDescription& vehicle);

/// What `vehicle` lacks to explore with a sensor; empty: nothing.
Problems check_sensor(ExploringSensor sensor, const std::string& camera, const VehicleDescription& vehicle);

}  // namespace aisle
