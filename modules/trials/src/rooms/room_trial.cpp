#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "aisle/commands/method.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/core/random.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/missions/statistics.hpp"
#include "mission_runs.hpp"
#include "rooms/room_missions.hpp"
#include "rooms/room_trial.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

Result<SimulationSetting> room_setting(const TrialOptions& options, const RoomLook& look,
                                       std::uint64_t seed) {
  const std::string world =
      options.worlds.empty() ? "laboratory" : options.worlds[seed % options.worlds.size()];
  auto setting = read_setting(world, kRoomMethod.vehicle_or_usual(options.vehicle), options.scenario);
  if (!setting) return setting.problems();
  Problems problems =
      unfit_for_rooms(setting->vehicle.description, {kFirstCamera, kSecondCamera, kThirdCamera});
  if (setting->world.routes.empty())
    problems.push_back({{setting->world_file.string(), 0, "routes"}, "are missing: nothing can be taught"});
  if (!problems.empty()) return problems;
  look.apply(setting->world);
  return setting;
}

/// Initial pose of the vehicle before the place where it is to park.
Pose2 disturbed_start(const SimulationSetting& setting, const Pose2& T_world_start, Random& random) {
  constexpr double kDisturbed_m = 0.5, kDisturbed_rad = 15 * kDegree;
  constexpr int kDraws = 100;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.uniform(-kDisturbed_m, kDisturbed_m),
                 y = random.uniform(-kDisturbed_m, kDisturbed_m);
    const Pose2 T_world_vehicle =
        T_world_start * Pose2{x, y, random.uniform(-kDisturbed_rad, kDisturbed_rad)};
    Footprint footprint = setting.vehicle.description.footprint;
    footprint.width_m += 0.1;
    footprint.front_m += 0.1;
    if (fits(setting.world, footprint, T_world_vehicle)) return T_world_vehicle;
  }
  return T_world_start;
}

/// The routes that end with a parking strategy; none given: all routes.
std::vector<const WorldRoute*> routes_of(const World& world, std::optional<ParkingStrategy> parking) {
  std::vector<const WorldRoute*> routes;
  for (const WorldRoute& route : world.routes)
    if (!parking || route.parking == *parking) routes.push_back(&route);
  return routes;
}

/// How a mission begins.
struct MissionBegin {
  SimulationSetting setting;
  Pose2 T_world_vehicle;
  double from_m = 0;  ///< initial estimate of the position along the route
};

/// One seed: teaches its route if need be, and drives it. @return its record
/// @param begin  (setting, taught route, seed) -> MissionBegin
template <class Begin>
Result<Json> room_seed(const TrialOptions& options, const RoomTrialParams& params,
                       std::optional<ParkingStrategy> parking, const Begin& begin,
                       TaughtRoutes& taught_routes, std::uint64_t seed, Progress& progress) {
  const auto setting = room_setting(options, params.look, seed);
  if (!setting) return setting.problems();
  const auto routes = routes_of(setting->world, parking);
  if (routes.empty())
    return Problem{{setting->world_file.string(), 0, "routes"},
                   fmt::format("none ends with parking: {}", parking_word(*parking))};
  const WorldRoute& route = *routes[seed % routes.size()];
  const auto taught = taught_routes.taught(*setting, route, seed, progress);
  if (!taught) return not_taught_record(seed, to_string(taught.problems()), route.name);
  const MissionBegin mission = begin(*setting, **taught, seed);
  const auto result = drive_taught(mission.setting, **taught, params.navigator, seed, mission.T_world_vehicle,
                                   mission.from_m, progress);
  if (!result) return result.problems();
  return room_record(*result, seed, route.name);
}

/// The missions of a trial, and what came of them.
struct RoomMissions {
  TrialRecords ran;
  RoomTrial trial;
};

/// One mission per seed, over the routes in turn.
template <class Begin>
Result<RoomMissions> drive_missions(const TrialOptions& options, const RoomTrialParams& params,
                                    std::optional<ParkingStrategy> parking, Console& console,
                                    const Begin& begin) {
  TaughtRoutes taught_routes(params, options.first_seed);
  auto ran = run_missions(options,
                          per_seed(options,
                                   [&](std::uint64_t seed, Console& quiet) {
                                     return room_seed(options, params, parking, begin, taught_routes, seed,
                                                      quiet.progress);
                                   }),
                          console);
  if (!ran) return ran.problems();
  RoomMissions missions{.ran = std::move(*ran), .trial = {}};
  for (const auto& [mission, record] : missions.ran.records) missions.trial.add(record);
  return missions;
}

Json park_figures(const RoomTrial& trial) {
  return {{"missions", trial.missions},
          {"success_share", trial.share(trial.arrived)},
          {"safe_stop_share", trial.share(trial.stopped)},
          {"collisions", trial.collisions},
          {"end_error_m", trial.end_m.json(4)},
          {"end_error_deg", trial.end_deg.json(3)},
          {"clearance_m", trial.clearance_m.json(3)},
          {"false_stops", trial.false_stops},
          {"cycle_ms", cycle_figures(trial.cycle_s)},
          {"simulated", true},
          {"not_taught", trial.not_taught.json()},
          {"runs", trial.runs}};
}

}  // namespace

Result<TrialResult> trial_by_route(const TrialOptions& options, const RoomTrialParams& params,
                                   Console& console) {
  auto missions =
      drive_missions(options, params, {}, console,
                     [&](const SimulationSetting& setting, const TaughtRoute& taught, std::uint64_t seed) {
                       Random random(seed);
                       SimulationSetting today = on_another_day(setting, params.change, random);
                       const Pose2 T_world_start = set_down_on_route(today, taught.place.at(0), seed);
                       return MissionBegin{std::move(today), T_world_start};
                     });
  if (!missions) return missions.problems();
  const RoomTrial& trial = missions->trial;
  Outcome outcome{.verb = "trial", .ok = trial.all_well()};
  outcome.figures = {{"missions", trial.missions},
                     {"arrived_share", trial.share(trial.arrived)},
                     {"safe_stop_share", trial.share(trial.stopped)}};
  outcome.figures.update(park_figures(trial));
  outcome.figures.erase("success_share");
  outcome.figures["method"] = "rooms";
  outcome.text = fmt::format(
      "simulated, furniture and light changed: {} missions driven, {:.1f} % of them arrived,\n"
      "{:.1f} % stopped safely, {} collisions\n",
      trial.missions, 100 * trial.share(trial.arrived), 100 * trial.share(trial.stopped), trial.collisions);
  outcome.text += trial.not_taught.text();
  return TrialResult{std::move(outcome), std::move(missions->ran)};
}

Result<TrialResult> trial_of_parking(const TrialOptions& options, const RoomTrialParams& given,
                                     Console& console) {
  constexpr double kBeforeEnd_m = 3.2;
  if (options.in_reverse && options.strategy != ParkingStrategy::kFrame)
    return Problem{{"--reverse"}, "vehicles park backwards in painted frames only"};
  RoomTrialParams params = given;
  params.navigator.frame_backing.wanted |= options.in_reverse;
  auto missions =
      drive_missions(options, params, options.strategy, console,
                     [&](const SimulationSetting& setting, const TaughtRoute& taught, std::uint64_t seed) {
                       const double from_m = std::max(0.0, taught.route.path.length_m() - kBeforeEnd_m);
                       Random change(seed), start(seed);
                       SimulationSetting today = on_another_day(setting, params.park_change, change);
                       const Pose2 T_world_start = disturbed_start(today, taught.place.at(from_m), start);
                       return MissionBegin{std::move(today), T_world_start, from_m};
                     });
  if (!missions) return missions.problems();
  const RoomTrial& trial = missions->trial;
  Outcome outcome{.verb = "trial", .ok = trial.all_well()};
  outcome.figures = park_figures(trial);
  outcome.figures["strategy"] = parking_word(options.strategy);
  outcome.text = fmt::format(
      "simulated, parking ({}) from disturbed starts: {} missions driven, {:.1f} % of them parked,\n"
      "{} collisions\n"
      "ended {:.1f} cm, {:.2f} deg off (mean), {:.1f} cm, {:.2f} deg (worst)\n",
      parking_word(options.strategy), trial.missions, 100 * trial.share(trial.arrived), trial.collisions,
      100 * trial.end_m.mean(), trial.end_deg.mean(), 100 * trial.end_m.worst(), trial.end_deg.worst());
  outcome.text += trial.not_taught.text();
  return TrialResult{std::move(outcome), std::move(missions->ran)};
}

}  // namespace aisle
