#pragma once

#include <optional>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/missions/exploration/fleet_driver.hpp"
#include "aisle/missions/mission_result.hpp"

namespace aisle {

/// Lets a vehicle drive what its fleet's master control orders, until its user or the vehicle ends it.
/// @param truth  of the vehicle; null: unknown
Result<MissionResult> drive_in_fleet(Vehicle& vehicle, const TruthSource* truth, FleetDriver& driver,
                                     std::optional<SessionRecord>& session, Progress& progress);

}  // namespace aisle
