#include "landmarks/landmark_mission.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "aisle/report/landmark_picture.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "rounded.hpp"
#include "simulated_record.hpp"
#include "statistics.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

ViewMatch landmark_match(const LandmarkNavigator& navigator) {
  const LandmarkLocaliser& localiser = navigator.localiser();
  return {localiser.matched_share(),
          fmt::format("{} of {} lines", localiser.pairs().size(), navigator.sightings().size())};
}

/// Records the mission's session, and collects the mission's result.
class LandmarkMissionRecord final : public SimulatedRecord {
 public:
  LandmarkMissionRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle,
                        const LandmarkNavigator& navigator, MissionJudge& judge,
                        LandmarkMissionResult& result)
      : SimulatedRecord(session, vehicle),
        vehicle_(vehicle),
        navigator_(navigator),
        judge_(judge),
        result_(result) {}

  Result<Observation> keep(Observation observation) override {
    auto kept = SimulatedRecord::keep(std::move(observation));
    if (kept) cycle_ = {.stamp_s = kept->stamp_s, .odometry = kept->odometry, .sightings = {}};
    return kept;
  }

  Problems keep(const Decision& decision) override {
    const LandmarkFix fix = navigator_.fix();
    judge_.add(cycle_.stamp_s, fix, vehicle_.truth().T_world_vehicle);
    result_.T_map_driven.push_back(fix.T_map_vehicle.mean);
    show_pose(fix.T_map_vehicle);
    if (is_watched() && !image_camera().empty()) {
      show_match(landmark_match(navigator_));
      show_overlay(overlay_of(navigator_, vehicle_.description(), image_camera()));
    }
    if (decision.state == "lost" && state_ != "lost") ++result_.lost_count;
    state_ = decision.state;
    cycle_.sightings = navigator_.sightings();
    result_.cycles.push_back(cycle_);
    return SimulatedRecord::keep(decision);
  }

 private:
  const SimulatedVehicle& vehicle_;
  const LandmarkNavigator& navigator_;
  MissionJudge& judge_;
  LandmarkMissionResult& result_;
  LandmarkCycle cycle_;
  std::string state_;
};

}  // namespace

Result<LandmarkMissionResult> drive_landmark_mission(const SimulationSetting& setting, LandmarkDriver& driver,
                                                     const MapTruth& truth,
                                                     const LandmarkMissionOptions& options,
                                                     std::optional<SessionRecord>& session,
                                                     Progress& progress) {
  const std::size_t taught = truth.start(options.in_reverse);
  const Pose2 T_world_start = truth.in_world(driver.path().at(0).T_map_path, taught);
  SimulatedVehicle vehicle(
      setting.world, setting.vehicle, setting.scenario,
      {.seed = options.seed,
       .T_world_start = set_down(
           setting, about(T_world_start, options.start_sigma_m, options.start_sigma_rad), options.seed)});
  MissionJudge judge(truth, driver.path(), options.in_reverse);
  LandmarkMissionResult result;
  result.T_map_start = driver.path().at(0).T_map_path;
  TimedNavigator timed(driver, result.cycle_s);
  LandmarkMissionRecord record(session, vehicle, driver.navigator(), judge, result);
  auto end = run_mission(vehicle, timed, record, progress);
  if (!end) return end.problems();
  result.end = std::move(*end);
  result.errors = judge.errors();
  result.collisions = vehicle.truth().collisions;
  result.distance_m = vehicle.truth().path_m;
  return result;
}

std::string trace_picture(const Building& building, const LandmarkMissionResult& result,
                          const std::string& title) {
  std::vector<Vec2> seen;
  for (std::size_t i = 0; i < result.cycles.size(); ++i) {
    for (const LandmarkSighting& sighting : result.cycles[i].sightings)
      seen.push_back(result.T_map_driven[i] * sighting.p_vehicle);
  }
  const std::vector<std::vector<Pose2>> driven{result.T_map_driven};
  return svg(LandmarkPicture{.landmarks = building.landmarks,
                             .routes = building.routes,
                             .driven = driven,
                             .seen = seen,
                             .title = title});
}

nlohmann::ordered_json figures_of(const LandmarkMissionResult& result) {
  const MissionErrors& errors = result.errors;
  return {
      {"arrived", result.end.arrived},
      {"state", result.end.state},
      {"why", result.end.why},
      {"collisions", result.collisions},
      {"lost_count", result.lost_count},
      {"distance_m", rounded(result.distance_m, 3)},
      {"duration_s", rounded(result.end.duration_s, 3)},
      {"localisation",
       {{"across_rmse_m", rounded(errors.across_m.rms(), 4)},
        {"along_rmse_m", rounded(errors.along_m.rms(), 4)},
        {"heading_rmse_deg", rounded(to_degrees(errors.heading_rad.rms()), 3)},
        {"wrong_confident", errors.wrong_confident},
        {"knew_place_at_end", errors.knew_place_at_end}}},
      {"tracking",
       {{"rmse_m", rounded(errors.tracking_m.rms(), 4)}, {"max_m", rounded(errors.tracking_m.worst(), 4)}}},
      {"cycle_ms", cycle_figures(result.cycle_s)}};
}

}  // namespace aisle
