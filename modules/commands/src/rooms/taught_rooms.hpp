#pragma once
/// Paths through rooms as trials teach them: a scripted person shows each once.

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "rooms/room_verbs.hpp"
#include "rooms/room_visit.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// A route as it was learned, and where it lies.
struct TaughtRoute {
  Route route;
  RouteInWorld place;
};

class TaughtRoutes {
 public:
  /// @param first_seed  gives each path's first taught run
  TaughtRoutes(const RoomTrialParams& params, std::uint64_t first_seed)
      : params_(params), first_seed_(first_seed) {}

  /// As it was learned; taught now if it was not yet. Where the first taught run was refused, the next is
  /// given by the seed that asks.
  /// @param setting  of the world as it is at teaching; worlds are distinguished by their file and name
  /// Problems: why the taught run was refused.
  Result<const TaughtRoute*> taught(const SimulationSetting& setting, const WorldRoute& path,
                                    std::uint64_t seed, Progress& progress);

 private:
  RoomTrialParams params_;
  std::uint64_t first_seed_;
  std::map<std::string, TaughtRoute> taught_;
  std::set<std::string> refused_;
};

}  // namespace aisle
