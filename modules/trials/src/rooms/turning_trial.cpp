#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "aisle/commands/method.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/simulation/buildings/turning_course.hpp"
#include "mission_count.hpp"
#include "rooms/room_missions.hpp"
#include "rooms/room_trial.hpp"

namespace aisle {
namespace {

/// The courses of `trial turnings`, by the numbers of their turnings.
std::vector<std::pair<std::string, World>> turning_courses(const TrialOptions& options) {
  std::vector<std::pair<std::string, World>> courses;
  const auto add = [&](const std::string& name, const auto& make) {
    Random random(options.first_seed);
    courses.emplace_back(name, make(random));
  };
  if (options.close) {
    add("6 then 5", [](Random& random) { return close_turnings_course(6, 5, random); });
    add("8 then 7", [](Random& random) { return close_turnings_course(8, 7, random); });
    return courses;
  }
  for (int number = 1; number <= kTurningNumbers; ++number)
    add(std::to_string(number), [number](Random& random) { return turning_course(number, random); });
  return courses;
}

}  // namespace

/// Every seed changes the light in the room.
Result<Outcome> trial_of_turnings(const TrialOptions& options, const RoomTrialParams& params,
                                  Console& console) {
  auto vehicle = read_setting("", kRoomMethod.vehicle_or_usual(options.vehicle), options.scenario);
  if (!vehicle) return vehicle.problems();
  if (Problems problems = unfit_for_rooms(vehicle->vehicle.description, {kFirstCamera, kThirdCamera});
      !problems.empty())
    return problems;
  const std::uint64_t seeds = options.last_seed - options.first_seed + 1;
  const auto courses = turning_courses(options);
  RoomTrial trial;
  nlohmann::ordered_json shares = nlohmann::ordered_json::object();
  MissionCount within(console.progress, "missions", courses.size() * seeds);
  TaughtRoutes taught_routes(params, options.first_seed);
  for (const auto& [name, world] : courses) {
    SimulationSetting setting = *vehicle;
    setting.world = world;
    setting.world.name = "turning " + name;
    const std::size_t missions_before = trial.missions, arrived_before = trial.arrived;
    for (std::uint64_t i = 0; i < seeds; ++i) {
      within.begin(trial.missions + trial.not_taught.size());
      const std::uint64_t seed = options.first_seed + i;
      const auto taught = taught_routes.taught(setting, world.routes.front(), seed, within);
      if (!taught) {
        trial.not_taught.add(seed, to_string(taught.problems()), setting.world.name);
        continue;
      }
      Random random(seed);
      const SimulationSetting today =
          on_another_day(setting, {.furniture_m = 0, .light_share = params.change.light_share}, random);
      const auto result = drive_taught(today, **taught, params.navigator, seed,
                                       set_down_on_route(today, (*taught)->place.at(0), seed), 0, within);
      if (!result) return result.problems();
      trial.add(*result, seed, setting.world.name);
    }
    const std::size_t driven = trial.missions - missions_before, good = trial.arrived - arrived_before;
    if (driven > 0) shares[name] = rounded(static_cast<double>(good) / static_cast<double>(driven), 4);
  }
  Outcome outcome{.verb = "trial", .ok = trial.all_well()};
  outcome.figures = {{"missions", trial.missions},
                     {"success_share", shares},
                     {"success_share_all", trial.share(trial.arrived)},
                     {"collisions", trial.collisions},
                     {"safe_stop_share", trial.share(trial.stopped)},
                     {"cycle_ms", cycle_figures(trial.cycle_s)},
                     {"simulated", true},
                     {"not_taught", trial.not_taught.json()},
                     {"runs", trial.runs}};
  outcome.text = fmt::format("simulated: {}, {} missions driven, {:.1f} % of them succeeded, {} collisions\n",
                             options.close ? "two close turnings" : "thirteen turnings", trial.missions,
                             100 * trial.share(trial.arrived), trial.collisions);
  outcome.text += trial.not_taught.text();
  return outcome;
}

}  // namespace aisle
