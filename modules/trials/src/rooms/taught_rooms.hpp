#pragma once
/// Paths through rooms, taught for trials: a scripted person drives each once.

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "aisle/commands/simulation_setting.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/evaluation/rooms/route_in_world.hpp"
#include "rooms/room_trial_params.hpp"

namespace aisle {

/// A learned route, and where it lies in the world.
struct TaughtRoute {
  Route route;
  RouteInWorld place;
};

class TaughtRoutes {
 public:
  /// @param first_seed  seed of each path's first taught run
  TaughtRoutes(const RoomTrialParams& params, std::uint64_t first_seed)
      : params_(params), first_seed_(first_seed) {}

  /// The learned route; teaches and learns it first if that has not been done. Where the taught run of the
  /// first seed was refused, each mission's own seed teaches once more, for that mission: so no mission
  /// depends on the others.
  /// @param setting  the world as it is during teaching; worlds are distinguished by file and name
  /// Problems: why the taught run was refused.
  Result<std::shared_ptr<const TaughtRoute>> taught(const SimulationSetting& setting,
                                                    const WorldRoute& world_route, std::uint64_t seed,
                                                    Progress& progress);

 private:
  RoomTrialParams params_;
  std::uint64_t first_seed_;
  std::map<std::string, Result<std::shared_ptr<const TaughtRoute>>> by_first_seed_;
};

}  // namespace aisle
