#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "aisle/commands/method.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/simulation/buildings/turning_course.hpp"
#include "mission_runs.hpp"
#include "rooms/room_missions.hpp"
#include "rooms/room_trial.hpp"

namespace aisle {
namespace {

/// The courses of `trial turnings`, by the numbers of their turnings.
std::vector<std::pair<std::string, World>> turning_courses(const TrialOptions& options) {
  std::vector<std::pair<std::string, World>> courses;
  const auto add = [&](const std::string& name, const auto& make) {
    Random random(options.first_seed);
    World world = make(random);
    world.name = "turning " + name;
    courses.emplace_back(name, std::move(world));
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

/// One seed on a course: teaches the course if need be, and drives it. @return its record
Result<nlohmann::ordered_json> drive_turning(const SimulationSetting& setting, const RoomTrialParams& params,
                                             TaughtRoutes& taught_routes, std::uint64_t seed,
                                             Progress& progress) {
  const auto taught = taught_routes.taught(setting, setting.world.routes.front(), seed, progress);
  if (!taught) return not_taught_record(seed, to_string(taught.problems()), setting.world.name);
  Random random(seed);
  const SimulationSetting today =
      on_another_day(setting, {.furniture_m = 0, .light_share = params.change.light_share}, random);
  const auto result = drive_taught(today, **taught, params.navigator, seed,
                                   set_down_on_route(today, (*taught)->place.at(0), seed), 0, progress);
  if (!result) return result.problems();
  return room_record(*result, seed, setting.world.name);
}

/// Share of the missions on each course that succeeded; courses without a mission are left out.
nlohmann::ordered_json success_shares(const RoomTrial& trial,
                                      const std::vector<std::pair<std::string, World>>& courses) {
  nlohmann::ordered_json shares = nlohmann::ordered_json::object();
  for (const auto& [name, world] : courses) {
    const auto good = trial.by_route.find(world.name);
    if (good == trial.by_route.end()) continue;
    const auto [arrived, missions] = good->second;
    shares[name] = rounded(static_cast<double>(arrived) / static_cast<double>(missions), 4);
  }
  return shares;
}

}  // namespace

/// Every seed changes the light in the room.
Result<TrialResult> trial_of_turnings(const TrialOptions& options, const RoomTrialParams& params,
                                      Console& console) {
  const auto vehicle = read_setting("", kRoomMethod.vehicle_or_usual(options.vehicle), options.scenario);
  if (!vehicle) return vehicle.problems();
  if (Problems problems = unfit_for_rooms(vehicle->vehicle.description, {kFirstCamera, kThirdCamera});
      !problems.empty())
    return problems;
  const auto courses = turning_courses(options);
  TaughtRoutes taught_routes(params, options.first_seed);
  const auto seed_of = [&](std::size_t mission) { return options.first_seed + mission % options.seeds(); };
  const auto course_of = [&](std::size_t mission) -> const World& {
    return courses[mission / options.seeds()].second;
  };
  const TrialMissions missions{
      .count = courses.size() * options.seeds(),
      .name = [&](std::size_t i) { return fmt::format("{}, seed {}", course_of(i).name, seed_of(i)); },
      .run = [&](std::size_t i, Console& quiet) -> Result<nlohmann::ordered_json> {
        SimulationSetting setting = *vehicle;
        setting.world = course_of(i);
        return drive_turning(setting, params, taught_routes, seed_of(i), quiet.progress);
      }};
  auto ran = run_missions(options, missions, console);
  if (!ran) return ran.problems();
  RoomTrial trial;
  for (const auto& [mission, record] : ran->records) trial.add(record);
  Outcome outcome{.verb = "trial", .ok = trial.all_well()};
  outcome.figures = {{"missions", trial.missions},
                     {"success_share", success_shares(trial, courses)},
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
  return TrialResult{std::move(outcome), std::move(*ran)};
}

}  // namespace aisle
