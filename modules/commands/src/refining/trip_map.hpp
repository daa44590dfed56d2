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
  std::size_t found = 0;  ///< of them, at which the vehicle was surely known to be somewhere
  int times_lost = 0;
  double path_m = 0;    ///< driven along those at which it was
  std::string why_not;  ///< why there are none; empty: there are some
};

/// Finds the vehicle of a log in a building, and lays the map that the log makes alone onto the building. The
/// last metres before it was lost do not count as found, nor does a place where it was soon lost again.
/// @param building  with walls and a floor
TripMap trip_map(const SettledLog& log, const Building& building, const LocaliserParams& params,
                 const std::optional<Pose2>& T_map_hint, Progress& progress);

}  // namespace aisle
