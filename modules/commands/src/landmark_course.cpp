#include "landmark_course.hpp"

#include <utility>

#include "aisle/formats/building_json.hpp"
#include "aisle/guidance/hand_driver.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// Collects a trip that a person drives.
class LessonRecord final : public MissionRecord {
 public:
  LessonRecord(const LandmarkSightingParams& params, const SimulatedVehicle& vehicle)
      : collector_(params, vehicle.description()), vehicle_(vehicle) {}

  Result<Observation> keep(Observation observation) override {
    collector_.add(observation);
    collector_.trip.T_world_vehicle.push_back(vehicle_.truth().T_world_vehicle);
    return observation;
  }
  Problems keep(const Decision&) override { return {}; }

  LandmarkTrip take() { return std::move(collector_.trip); }

 private:
  LandmarkTripCollector collector_;
  const SimulatedVehicle& vehicle_;
};

}  // namespace

void LandmarkCourseParams::describe(FieldList& fields) {
  fields.group("lesson", lesson);
  fields.group("navigator", navigator);
  fields.group("person", person);
}

Problems keep_corridor_camera(SimulationSetting& setting) {
  auto& cameras = setting.vehicle.description.cameras;
  if (cameras.empty()) return {{{"", 0, "cameras"}, "there is none: nothing can be learned"}};
  cameras = {CameraDescription(corridor_camera(setting.vehicle.description))};
  return {};
}

Result<std::optional<LandmarkTrip>> teach_trip(const SimulationSetting& setting,
                                               const LandmarkCourseParams& params, std::uint64_t seed,
                                               Progress& progress) {
  const auto start = start_in(setting);
  if (!start) return start.problems();
  ScriptedOperator person(setting.world, setting.vehicle.description, params.person, seed);
  SimulatedVehicle vehicle(setting.world, setting.vehicle, {}, {.seed = seed, .T_world_start = *start},
                           &person);
  HandDriver driver({});
  LessonRecord record(params.lesson.sightings, vehicle);
  const auto end = run_mission(vehicle, driver, record, progress);
  if (!end) return end.problems();
  if (!person.has_arrived()) return std::optional<LandmarkTrip>();
  return std::optional<LandmarkTrip>(record.take());
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

void refine_by(const LandmarkMissionResult& mission, const VehicleDescription& vehicle,
               const LandmarkLearningParams& params, Building& building) {
  building.landmarks =
      refine_landmarks(building.landmarks, mission.cycles, vehicle, about_start(mission.T_map_start), params)
          .map;
}

}  // namespace aisle
