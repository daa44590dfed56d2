#pragma once
/// What the trials through rooms have in common: missions along taught routes, and their statistics.

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "aisle/commands/simulation_setting.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/core/random.hpp"
#include "aisle/core/result.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/evaluation/rooms/room_evaluation.hpp"
#include "aisle/guidance/rooms/room_navigator.hpp"
#include "aisle/missions/statistics.hpp"
#include "not_taught.hpp"
#include "rooms/room_trial_params.hpp"
#include "rooms/taught_rooms.hpp"

namespace aisle {

/// The same room on another day: with moved furniture and changed light.
SimulationSetting on_another_day(SimulationSetting setting, const RoomChange& change, Random& random);

/// The record of a mission along a route.
nlohmann::ordered_json room_record(const JudgedRoomMission& judged, std::uint64_t seed,
                                   const std::string& route);

/// Shares refer to the missions that were driven; without a taught run there is no mission.
struct RoomTrial {
  std::size_t missions = 0, arrived = 0, stopped = 0, collisions = 0, false_stops = 0;
  Spread end_m, end_deg, clearance_m;
  std::vector<double> cycle_s;
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  NotTaught not_taught;
  /// Arrived and driven missions of each route.
  std::map<std::string, std::pair<std::size_t, std::size_t>> by_route;

  bool all_well() const { return missions > 0 && arrived == missions; }
  void add(const nlohmann::ordered_json& record);
  double share(std::size_t count) const {
    return rounded(static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(missions, 1)), 4);
  }
};

/// Lets a vehicle drive a taught route from a pose.
/// @param from_m  initial estimate of the position along the route
Result<JudgedRoomMission> drive_taught(SimulationSetting setting, const TaughtRoute& taught,
                                       const RoomNavigatorParams& params, std::uint64_t seed,
                                       const Pose2& T_world_start, double from_m, Progress& progress);

}  // namespace aisle
