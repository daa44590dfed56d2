#include "exploration/exploration_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "aisle/commands/exploration/judged_exploration.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/evaluation/exploration/exploration_evaluation.hpp"
#include "mission_runs.hpp"
#include "random_start.hpp"
#include "trial_setting.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSpaceAhead_m = 0.15;  // of a vehicle that starts anywhere

/// Figures whose mean and worst are reported.
constexpr const char* kErrorFigures[] = {"home_error_m",      "home_error_deg",   "wall_rmse_m",
                                         "wall_missed_share", "wall_false_share", "distance_m",
                                         "graph_bound_m"};
constexpr const char* kShareFigures[] = {"covered_share", "mapped_share"};

void scale_noise(WheelErrors& errors, double scale) {
  for (double* error :
       {&errors.distance_scale, &errors.distance_slip_m_per_sqrt_m, &errors.heading_slip_rad_per_sqrt_m,
        &errors.steering_bias_rad, &errors.wheel_difference})
    *error *= scale;
}

Result<SimulationSetting> exploration_setting(const TrialOptions& options, const ExploreOptions& explore,
                                              std::uint64_t seed) {
  auto setting = setting_of_seed(options, seed, exploring_vehicle(explore), kBuildingKinds);
  if (!setting) return setting.problems();
  scale_noise(setting->vehicle.simulated.odometry, options.noise_scale);
  return setting;
}

bool is_complete(const Json& figures) {
  return figures["came_home"].get<bool>() && figures["collisions"] == 0 &&
         figures["covered_share"].get<double>() >= kCompleteShare;
}

bool has_certificate(const Json& figures) {
  return figures["certificate"].get<bool>();
}

/// Mean and worst of a figure; the worst share is the smallest.
Json spread_of(const Json& missions, const char* figure, bool least_is_worst) {
  double sum = 0, worst = least_is_worst ? std::numeric_limits<double>::infinity() : 0;
  for (const Json& mission : missions) {
    const double value = mission[figure].get<double>();
    sum += value;
    worst = least_is_worst ? std::min(worst, value) : std::max(worst, value);
  }
  if (missions.empty()) return nullptr;
  return {{"mean", rounded(sum / static_cast<double>(missions.size()), 5)}, {"worst", rounded(worst, 5)}};
}

Outcome outcome_of(const TrialOptions& options, const Json& missions) {
  const auto complete = std::count_if(missions.begin(), missions.end(), is_complete);
  const auto certified = std::count_if(missions.begin(), missions.end(), has_certificate);
  std::size_t collisions = 0;
  for (const Json& mission : missions) collisions += mission["collisions"].get<std::size_t>();
  const auto count = static_cast<double>(std::max<std::size_t>(missions.size(), 1));
  Outcome outcome{.verb = "trial", .ok = complete == static_cast<std::ptrdiff_t>(missions.size())};
  outcome.figures = {{"simulated", true},
                     {"method", options.method},
                     {"noise_scale", options.noise_scale},
                     {"starts_anywhere", options.starts_anywhere},
                     {"missions", missions.size()},
                     {"complete_share", rounded(static_cast<double>(complete) / count, 4)},
                     {"certificate_share", rounded(static_cast<double>(certified) / count, 4)},
                     {"collisions", collisions}};
  for (const char* figure : kShareFigures) outcome.figures[figure] = spread_of(missions, figure, true);
  for (const char* figure : kErrorFigures) outcome.figures[figure] = spread_of(missions, figure, false);
  outcome.figures["runs"] = missions;
  outcome.text = fmt::format("simulated: {} of {} missions complete, {} with a certificate, {} collisions\n",
                             complete, missions.size(), certified, collisions);
  for (const Json& mission : missions) {
    outcome.text +=
        fmt::format("{:<16} {:<10} covered {:.3f}, home to {:.3f} m, {:.1f} m driven: {}\n",
                    mission["world"].get<std::string>(), is_complete(mission) ? "complete" : "incomplete",
                    mission["covered_share"].get<double>(), mission["home_error_m"].get<double>(),
                    mission["distance_m"].get<double>(), mission["ended_because"].get<std::string>());
  }
  return outcome;
}

/// One building explored. @return its record: the mission's figures
Result<Json> explore_seed(const TrialOptions& options, std::uint64_t seed, Console& console) {
  ExploreOptions explore;
  explore.parameters = options.parameters;
  explore.sensor = options.sensor;
  explore.vehicle = options.vehicle;
  explore.seed = seed;
  auto setting = exploration_setting(options, explore, seed);
  if (!setting) return setting.problems();
  Json mission = {{"world", setting->world.name}};
  if (options.starts_anywhere) {
    const auto T_world_start = random_start(*setting, kSpaceAhead_m, seed);
    if (!T_world_start) return T_world_start.problems();
    explore.T_world_start = *T_world_start;
    mission["start"] = {rounded(T_world_start->x, 3), rounded(T_world_start->y, 3),
                        rounded(to_degrees(T_world_start->theta), 1)};
  }
  const auto plan = read_exploration_plan(explore, std::move(*setting));
  if (!plan) return plan.problems();
  const auto explored = explore_and_judge(explore, *plan, console);
  if (!explored) return explored.problems();
  mission.update(explored->outcome.figures);
  return Json{{"ok", is_complete(mission)}, {"run", mission}};
}

}  // namespace

Result<TrialResult> run_exploration_trial(const TrialOptions& options, Console& console) {
  auto ran = run_missions(
      options,
      per_seed(options,
               [&](std::uint64_t seed, Console& quiet) { return explore_seed(options, seed, quiet); }),
      console);
  if (!ran) return ran.problems();
  Json missions = Json::array();
  for (const auto& [mission, record] : ran->records) missions.push_back(record.at("run"));
  Outcome outcome = outcome_of(options, missions);
  return TrialResult{std::move(outcome), std::move(*ran)};
}

}  // namespace aisle
