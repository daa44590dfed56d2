#include "localisation/localisation_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/process_usage.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/guidance/exploration/place_finder.hpp"
#include "aisle/missions/statistics.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "localisation/known_world.hpp"
#include "mission_runs.hpp"
#include "random_start.hpp"
#include "trial_setting.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kWrong_m = 0.5;  // farther from the truth, a found place is a wrong one
constexpr double kWrong_rad = 10 * kDegree;
constexpr double kSoon_s = 30;
constexpr double kSoon_m = 3;
constexpr double kAhead_m = 1.2;  // space to set off without seeing what is behind it

/// One vehicle, put down somewhere, until it is found or gives up.
Json find_once(const PlaceFinderParams& params, const SimulationSetting& setting, const Building& known,
               const Pose2& T_world_start, std::uint64_t seed) {
  SimulatedVehicle vehicle = vehicle_in(setting, T_world_start, seed);
  PlaceFinder finder(params, setting.vehicle.description, known, {});
  Decision decision;
  std::optional<double> begun_s;
  double now_s = 0;
  std::vector<double> cycle_s;
  while (decision.status == NavigatorStatus::kGoing) {
    const auto observation = vehicle.sense();
    if (!observation) break;
    now_s = observation->stamp_s;
    if (!begun_s) begun_s = now_s;
    const double start_s = process_cpu_s();
    decision = finder.step(*observation);
    cycle_s.push_back(process_cpu_s() - start_s);
    vehicle.act(decision.command);
  }
  const bool is_found = decision.status == NavigatorStatus::kDone;
  const Pose2 off = between(vehicle.truth().T_world_vehicle, finder.localiser().T_map_vehicle().mean);
  const bool is_wrong = is_found && (off.position().norm() > kWrong_m || std::abs(off.theta) > kWrong_rad);
  Json run = {{"world", setting.world.name},
              {"seed", seed},
              {"found", is_found},
              {"wrong", is_wrong},
              {"time_s", rounded(now_s - begun_s.value_or(now_s), 1)},
              {"distance_m", rounded(vehicle.truth().path_m, 3)},
              {"collisions", vehicle.truth().collisions},
              {"search_ms", rounded(1e3 * quantile(cycle_s, 1), 1)},
              {"why", decision.why}};
  if (is_found) {
    run["error_m"] = rounded(off.position().norm(), 4);
    run["error_deg"] = rounded(to_degrees(std::abs(off.theta)), 3);
  }
  return run;
}

bool is_found_soon(const Json& run) {
  return run["found"].get<bool>() && !run["wrong"].get<bool>() && run["time_s"].get<double>() <= kSoon_s &&
         run["distance_m"].get<double>() <= kSoon_m;
}

double share_of_runs(const Json& runs, bool (*counts)(const Json&)) {
  return static_cast<double>(std::count_if(runs.begin(), runs.end(), counts)) /
         static_cast<double>(std::max<std::size_t>(runs.size(), 1));
}

Json quantiles_over(const Json& runs, const char* figure) {
  std::vector<double> values;
  for (const Json& run : runs) {
    if (run.contains(figure)) values.push_back(run[figure].get<double>());
  }
  return {{"median", rounded(quantile(values, 0.5), 4)}, {"worst", rounded(quantile(values, 1), 4)}};
}

Outcome localisation_outcome(const TrialOptions& options, const Json& runs) {
  const auto wrong =
      std::count_if(runs.begin(), runs.end(), [](const Json& run) { return run["wrong"].get<bool>(); });
  std::size_t collisions = 0;
  for (const Json& run : runs) collisions += run["collisions"].get<std::size_t>();
  const double found_share = share_of_runs(
      runs, [](const Json& run) { return run["found"].get<bool>() && !run["wrong"].get<bool>(); });
  const double soon_share = share_of_runs(runs, is_found_soon);
  Outcome outcome{.verb = "trial", .ok = wrong == 0 && collisions == 0};
  outcome.figures = {{"simulated", true},
                     {"method", options.method},
                     {"outdated_map", options.outdated_map},
                     {"missions", runs.size()},
                     {"found_share", rounded(found_share, 4)},
                     {"found_soon_share", rounded(soon_share, 4)},
                     {"wrong_confident", wrong},
                     {"collisions", collisions}};
  for (const char* figure : {"time_s", "distance_m", "error_m", "error_deg", "search_ms"})
    outcome.figures[figure] = quantiles_over(runs, figure);
  outcome.figures["runs"] = runs;
  outcome.text = fmt::format(
      "simulated: {} missions, {:.1f} % found, {:.1f} % within {:g} s and {:g} m, {} sure of a wrong place\n",
      runs.size(), 100 * found_share, 100 * soon_share, kSoon_s, kSoon_m, wrong);
  for (const Json& run : runs) {
    outcome.text += fmt::format("{:<16} {:<9} {:5.1f} s {:5.2f} m  {}\n", run["world"].get<std::string>(),
                                run["wrong"].get<bool>()   ? "WRONG"
                                : run["found"].get<bool>() ? "found"
                                                           : "not found",
                                run["time_s"].get<double>(), run["distance_m"].get<double>(),
                                run["why"].get<std::string>());
  }
  return outcome;
}

/// One building, one place in it that the vehicle is put down at and not told. @return its record
Result<Json> localise_seed(const TrialOptions& options, const PlaceFinderParams& params, std::uint64_t seed,
                           Progress& progress) {
  const std::string vehicle = options.vehicle.empty() ? "alv-scanner" : options.vehicle;
  auto setting = setting_of_seed(options, seed, vehicle, kBuildingKinds);
  if (!setting) return setting.problems();
  setting->vehicle.description.cameras.clear();
  if (!setting->vehicle.description.scanner)
    return Problem{{vehicle, 0, "scanner"}, "is missing: the vehicle cannot see walls"};
  const auto start = start_in(*setting);
  if (!start) return start.problems();
  const auto T_world_start = random_start(*setting, kAhead_m, seed);
  if (!T_world_start) return T_world_start.problems();
  const FreeFloor seen(cross_section(setting->world, setting->vehicle.simulated.scanner.height_m),
                       start->position(), 0.03);
  const Result<Building> known = options.outdated_map
                                     ? outdated_map_of_world(*setting, seen, Random(seed ^ 0x01d), progress)
                                     : building_of_world(*setting, seen);
  if (!known) return known.problems();
  const Json run = find_once(params, *setting, *known, *T_world_start, seed);
  return Json{{"ok", is_found_soon(run)}, {"run", run}};
}

}  // namespace

Result<TrialResult> run_localisation_trial(const TrialOptions& options, Console& console) {
  PlaceFinderParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  auto ran = run_missions(
      options,
      per_seed(options, [&](std::uint64_t seed,
                            Console& quiet) { return localise_seed(options, params, seed, quiet.progress); }),
      console);
  if (!ran) return ran.problems();
  Json runs = Json::array();
  for (const auto& [mission, record] : ran->records) runs.push_back(record.at("run"));
  Outcome outcome = localisation_outcome(options, runs);
  return TrialResult{std::move(outcome), std::move(*ran)};
}

}  // namespace aisle
