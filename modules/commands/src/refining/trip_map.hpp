#pragma once

#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/localisation/localiser.hpp"
#include "aisle/maps/building.hpp"
#include "settled_log.hpp"

namespace aisle {

/// What one trip shows of a known building.
struct TripMap {
  Building building;  ///< its walls and floor, in the building's frame
  std::size_t scans = 0;
  std::size_t used = 0;  ///< of them, at which the vehicle was surely known to be somewhere
  int times_lost = 0;
  double path_m = 0;    ///< driven along those that were used
  std::string why_not;  ///< why none were used; empty: some were
};

/// Finds the vehicle of a log in a building, and draws what it saw from where it was found. The last metres
/// before it was lost are not used, nor is a place where it was found and soon lost again.
/// @param building  with walls and a floor
TripMap trip_map(const SettledLog& log, const Building& building, const LocaliserParams& params,
                 const std::optional<Pose2>& T_map_hint, Progress& progress);

}  // namespace aisle
