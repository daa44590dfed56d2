#include "landmarks/landmark_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/commands/method.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/missions/statistics.hpp"
#include "mission_runs.hpp"
#include "not_taught.hpp"
#include "trial_setting.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

Result<SimulationSetting> landmark_setting(const TrialOptions& options, std::uint64_t seed) {
  auto setting =
      setting_of_seed(options, seed, kLandmarkMethod.vehicle_or_usual(options.vehicle), kBuildingKinds);
  if (!setting) return setting.problems();
  if (Problems problems = keep_corridor_camera(*setting); !problems.empty())
    return at_file(problems, options.vehicle);
  return setting;
}

/// What the statistics need of a mission: exact, unlike its figures.
Json counted_of(const JudgedLandmarkMission& judged, std::size_t landmarks) {
  const LandmarkMissionResult& mission = judged.mission;
  const MissionErrors& errors = *judged.errors;
  return {{"arrived", mission.end.arrived},
          {"collisions", mission.truth->collisions},
          {"wrong_confident", errors.wrong_confident},
          {"knew_place_at_end", errors.knew_place_at_end},
          {"lost", mission.lost_count},
          {"distance_m", mission.distance_m()},
          {"across_m", errors.across_m.rms()},
          {"along_m", errors.along_m.rms()},
          {"heading_deg", to_degrees(errors.heading_rad.rms())},
          {"tracking_m", errors.tracking_m.rms()},
          {"tracking_worst_m", errors.tracking_m.worst()},
          {"landmarks", landmarks},
          {"cycle_s", mission.cycle_s}};
}

/// Statistics of all missions after a number of refinements.
class LandmarkStatistics {
 public:
  void add(const Json& counted) {
    const auto count = [&](const char* what) { return counted.at(what).get<bool>() ? 1U : 0U; };
    ++missions_;
    arrived_ += count("arrived");
    collisions_ += counted.at("collisions").get<std::size_t>();
    wrong_confident_ += count("wrong_confident");
    knew_place_at_end_ += count("knew_place_at_end");
    lost_.add(counted.at("lost"));
    distance_m_.add(counted.at("distance_m"));
    across_m_.add(counted.at("across_m"));
    along_m_.add(counted.at("along_m"));
    heading_deg_.add(counted.at("heading_deg"));
    tracking_m_.add(counted.at("tracking_m"));
    tracking_worst_m_.add(counted.at("tracking_worst_m"));
    landmarks_.add(counted.at("landmarks"));
    for (const Json& cycle_s : counted.at("cycle_s")) cycle_s_.push_back(cycle_s);
  }

  bool all_well() const { return arrived_ == missions_ && collisions_ == 0; }

  Json json() const {
    return {{"missions", missions_},
            {"arrived_share", share(arrived_)},
            {"collisions", collisions_},
            {"wrong_confident", wrong_confident_},
            {"knew_place_at_end_share", share(knew_place_at_end_)},
            {"lost_count", lost_.json(2)},
            {"distance_m", distance_m_.json(1)},
            {"localisation",
             {{"across_rmse_m", across_m_.json(4)},
              {"along_rmse_m", along_m_.json(4)},
              {"heading_rmse_deg", heading_deg_.json(3)}}},
            {"tracking", {{"rmse_m", tracking_m_.json(4)}, {"max_m", tracking_worst_m_.json(4)}}},
            {"landmarks", landmarks_.json(1)},
            {"cycle_ms", cycle_figures(cycle_s_)}};
  }

 private:
  double share(std::size_t missions) const {
    return rounded(static_cast<double>(missions) / std::max<double>(static_cast<double>(missions_), 1), 4);
  }

  std::size_t missions_ = 0, arrived_ = 0, collisions_ = 0, wrong_confident_ = 0, knew_place_at_end_ = 0;
  Spread lost_, distance_m_, across_m_, along_m_, heading_deg_, tracking_m_, tracking_worst_m_, landmarks_;
  std::vector<double> cycle_s_;
};

Json mission_json(std::uint64_t seed, const SimulationSetting& setting, int refinement,
                  const JudgedLandmarkMission& result) {
  Json json = {{"seed", seed},
               {"world", setting.world.name.empty() ? setting.world_file.string() : setting.world.name},
               {"refinement", refinement}};
  json.update(figures_of(result));
  return json;
}

/// One seed: teach, learn, then drive and refine as often as requested. Its record holds each drive, or why
/// the route was not taught.
Result<Json> landmark_record(const TrialOptions& options, const LandmarkCourseParams& params,
                             std::uint64_t seed, Progress& progress) {
  const auto setting = landmark_setting(options, seed);
  if (!setting) return setting.problems();
  const auto run = teach_run(*setting, params, seed, progress);
  if (!run) return run.problems();
  if (!*run) return not_taught_record(seed, "the person did not get through");
  const auto learned = learn_route(**run, "route", params.learner);
  if (!learned) return not_taught_record(seed, to_string(learned.problems()));
  const MapTruth truth(learned->T_map_taught, (*run)->T_world_vehicle);
  Building building = learned->building;
  Json record = {{"ok", true}, {"drives", Json::array()}};
  for (int refinement = 0; refinement <= options.refinements; ++refinement) {
    const std::uint64_t mission_seed = 1000 * (seed + 1) + static_cast<std::uint64_t>(refinement);
    SimulationSetting present = *setting;
    if (options.lift_m) {
      const auto lift =
          lift_on_route(present, building.routes.front().path, truth, *options.lift_m, mission_seed);
      if (!lift)
        return Problem{{},
                       fmt::format("seed {}: the path is too short to kidnap the vehicle along it", seed)};
      present.scenario.events.push_back(*lift);
    }
    const auto result =
        drive_alone(present, params, building, truth, mission_seed, options.in_reverse, progress);
    if (!result) return result.problems();
    if (!result->mission.end.arrived || result->mission.truth->collisions > 0) record["ok"] = false;
    record["drives"].push_back({{"run", mission_json(seed, *setting, refinement, *result)},
                                {"counted", counted_of(*result, building.landmarks.size())}});
    refine_by(result->mission, setting->vehicle.description, params.learner.learning, building);
  }
  return record;
}

struct LandmarkTrial {
  std::vector<LandmarkStatistics> after;  ///< index: number of refinements
  Json missions = Json::array();
  NotTaught not_taught;

  void add(const Json& record) {
    if (not_taught.add(record)) return;
    for (std::size_t i = 0; i < record.at("drives").size(); ++i) {
      const Json& drive = record["drives"][i];
      after.at(i).add(drive.at("counted"));
      missions.push_back(drive.at("run"));
    }
  }
};

Outcome landmark_outcome(const TrialOptions& options, const LandmarkTrial& trial) {
  Outcome outcome{.verb = "trial"};
  outcome.figures = trial.after.back().json();
  outcome.figures["simulated"] = true;
  outcome.figures["method"] = options.method;
  if (options.refinements > 0) {
    for (const LandmarkStatistics& statistics : trial.after)
      outcome.figures["after_refinements"].push_back(statistics.json());
  }
  outcome.figures["not_taught"] = trial.not_taught.json();
  outcome.figures["runs"] = trial.missions;
  outcome.text =
      "simulated\n after  missions  arrived  collisions  across  along    heading  tracking  worst\n";
  for (std::size_t i = 0; i < trial.after.size(); ++i) {
    const Json figures = trial.after[i].json();
    const Json& where = figures["localisation"];
    outcome.text += fmt::format(
        "{:>6}  {:>8}  {:>6.1f}%  {:>10}  {:>4.1f}cm  {:>4.1f}cm  {:>5.2f}deg  {:>6.1f}cm  {:>4.1f}cm\n", i,
        figures["missions"].get<int>(), 100 * figures["arrived_share"].get<double>(),
        figures["collisions"].get<int>(), 100 * where["across_rmse_m"]["mean"].get<double>(),
        100 * where["along_rmse_m"]["mean"].get<double>(), where["heading_rmse_deg"]["mean"].get<double>(),
        100 * figures["tracking"]["rmse_m"]["mean"].get<double>(),
        100 * figures["tracking"]["max_m"]["worst"].get<double>());
    outcome.ok = outcome.ok && trial.after[i].all_well();
  }
  outcome.text += trial.not_taught.text();
  return outcome;
}

}  // namespace

Result<TrialResult> trial_by_landmarks(const TrialOptions& options, const LandmarkCourseParams& params,
                                       Console& console) {
  auto ran = run_missions(options,
                          per_seed(options,
                                   [&](std::uint64_t seed, Console& quiet) {
                                     return landmark_record(options, params, seed, quiet.progress);
                                   }),
                          console);
  if (!ran) return ran.problems();
  LandmarkTrial trial;
  trial.after.resize(static_cast<std::size_t>(options.refinements) + 1);
  for (const auto& [mission, record] : ran->records) trial.add(record);
  Outcome outcome = landmark_outcome(options, trial);
  return TrialResult{std::move(outcome), std::move(*ran)};
}

}  // namespace aisle
