#include "landmarks/landmark_course.hpp"

#include <algorithm>
#include <utility>

#include "aisle/commands/set_down.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/guidance/hand_driver.hpp"

namespace aisle {
namespace {

/// Records a run that a person drives.
class TaughtRunRecord final : public MissionRecord {
 public:
  TaughtRunRecord(const LandmarkSightingParams& params, const VehicleDescription& vehicle,
                  const TruthSource& truth)
      : collector_(params, vehicle), truth_(truth) {}

  Result<Observation> keep(Observation observation) override {
    collector_.add(observation);
    collector_.run.T_world_vehicle.push_back(truth_.truth().T_world_vehicle);
    return observation;
  }
  Problems keep(const Decision&) override { return {}; }

  LandmarkRun take() { return std::move(collector_.run); }

 private:
  LandmarkRunCollector collector_;
  const TruthSource& truth_;
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
  TaughtRunRecord record(params.learner.sightings, vehicle.description(), vehicle);
  const auto end = run_mission(vehicle, driver, record, progress);
  if (!end) return end.problems();
  if (!person.has_arrived()) return std::optional<LandmarkRun>();
  return std::optional<LandmarkRun>(record.take());
}

Result<JudgedLandmarkMission> drive_alone(const SimulationSetting& setting,
                                          const LandmarkCourseParams& params, const Building& building,
                                          const MapTruth& truth, std::uint64_t seed, bool in_reverse,
                                          Progress& progress) {
  const LandmarkMission mission{building_json(building), building.routes.front().name, in_reverse};
  const auto driver =
      LandmarkDriver::make(LandmarkDriver::origin(params.navigator, mission), setting.vehicle.description);
  if (!driver) return driver.problems();
  const Path& path = (*driver)->path();
  const Pose2 T_world_start = truth.in_world(path.at(0).T_map_path, truth.start(in_reverse));
  SimulatedVehicle vehicle = vehicle_in(setting, set_down_for_landmarks(setting, T_world_start, seed), seed);
  std::optional<SessionRecord> no_session;
  auto driven = drive_landmark_mission(vehicle, &vehicle, **driver, no_session, progress);
  if (!driven) return driven.problems();
  return judged(std::move(*driven), truth, path, in_reverse);
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
