#include "landmarks/landmark_course.hpp"

#include <algorithm>
#include <utility>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/guidance/hand_driver.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// Records a run that a person drives.
class TaughtRunRecord final : public MissionRecord {
 public:
  TaughtRunRecord(const LandmarkSightingParams& params, const SimulatedVehicle& vehicle)
      : collector_(params, vehicle.description()), vehicle_(vehicle) {}

  Result<Observation> keep(Observation observation) override {
    collector_.add(observation);
    collector_.run.T_world_vehicle.push_back(vehicle_.truth().T_world_vehicle);
    return observation;
  }
  Problems keep(const Decision&) override { return {}; }

  LandmarkRun take() { return std::move(collector_.run); }

 private:
  LandmarkRunCollector collector_;
  const SimulatedVehicle& vehicle_;
};

}  // namespace

void LandmarkCourseParams::describe(FieldList& fields) {
  fields.group("learner", learner);
  fields.group("navigator", navigator);
  fields.group("person", person);
}

Problems keep_corridor_camera(SimulationSetting& setting) {
  auto& cameras = setting.vehicle.description.cameras;
  if (cameras.empty()) return {{{"", 0, "cameras"}, "there is none: nothing can be learned"}};
  cameras = {CameraDescription(corridor_camera(setting.vehicle.description))};
  return {};
}

Result<std::optional<LandmarkRun>> teach_run(const SimulationSetting& setting,
                                             const LandmarkCourseParams& params, std::uint64_t seed,
                                             Progress& progress) {
  const auto start = start_in(setting);
  if (!start) return start.problems();
  ScriptedOperator person(setting.world, setting.vehicle.description, params.person, seed);
  SimulatedVehicle vehicle(setting.world, setting.vehicle, {}, {.seed = seed, .T_world_start = *start},
                           &person);
  HandDriver driver({});
  TaughtRunRecord record(params.learner.sightings, vehicle);
  const auto end = run_mission(vehicle, driver, record, progress);
  if (!end) return end.problems();
  if (!person.has_arrived()) return std::optional<LandmarkRun>();
  return std::optional<LandmarkRun>(record.take());
}

Result<LandmarkMissionResult> drive_alone(const SimulationSetting& setting,
                                          const LandmarkCourseParams& params, const Building& building,
                                          const MapTruth& truth, const LandmarkMissionOptions& options,
                                          Progress& progress) {
  const LandmarkMission mission{building_json(building), building.routes.front().name, options.in_reverse};
  const auto driver =
      LandmarkDriver::make(LandmarkDriver::origin(params.navigator, mission), setting.vehicle.description);
  if (!driver) return driver.problems();
  std::optional<SessionRecord> no_session;
  return drive_landmark_mission(setting, **driver, truth, options, no_session, progress);
}

std::optional<ScenarioEvent> lift_on_route(const SimulationSetting& setting, const Path& path,
                                           const MapTruth& truth, double lift_m, std::uint64_t seed) {
  constexpr double kFromEnds_m = 1, kLateral_m = 0.15, kTurned_rad = 5 * kDegree;
  constexpr int kTrials = 50;
  Random random(seed);
  for (int trial = 0; trial < kTrials; ++trial) {
    const double from_m = random.uniform(kFromEnds_m, std::max(kFromEnds_m, path.length_m() - kFromEnds_m));
    const double to_m = from_m + (random.uniform(0, 1) < 0.5 ? -lift_m : lift_m);
    const Pose2 off{0, random.uniform(-kLateral_m, kLateral_m), random.uniform(-kTurned_rad, kTurned_rad)};
    if (to_m < kFromEnds_m || to_m > path.length_m() - kFromEnds_m) continue;
    const Pose2 T_world_to = truth.in_world(path.at(to_m).T_map_path) * off;
    if (!fits(setting.world, setting.vehicle.description.footprint, T_world_to)) continue;
    return ScenarioEvent{.fault = Lifted{T_world_to},
                         .near = truth.in_world(path.at(from_m).T_map_path).position(),
                         .radius_m = 0.3};
  }
  return std::nullopt;
}

void refine_by(const LandmarkMissionResult& mission, const VehicleDescription& vehicle,
               const LandmarkLearningParams& params, Building& building) {
  building.landmarks =
      refine_landmarks(building.landmarks, mission.cycles, vehicle, about_start(mission.T_map_start), params)
          .map;
}

}  // namespace aisle
