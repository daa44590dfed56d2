#pragma once
/// The life of a taught route in simulation: a person drives it, it is learned, the vehicle drives it alone.

#include <cstdint>
#include <optional>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/simulation/operators/scripted_operator.hpp"
#include "landmarks/landmark_learning_result.hpp"
#include "landmarks/landmark_mission.hpp"
#include "landmarks/landmark_run.hpp"
#include "simulation_setting.hpp"

namespace aisle {

struct LandmarkCourseParams {
  LandmarkLearnerParams learner;
  LandmarkNavigatorParams navigator;
  ScriptedOperatorParams person;

  void describe(FieldList& fields);
};

/// Leaves the vehicle the one camera that landmarks are seen with. A vehicle without any is a problem.
Problems keep_corridor_camera(SimulationSetting& setting);

/// A person drives the world's tour, recorded in memory.
/// @return nullopt: the person did not get through
Result<std::optional<LandmarkRun>> teach_run(const SimulationSetting& setting,
                                             const LandmarkCourseParams& params, std::uint64_t seed,
                                             Progress& progress);

/// The vehicle drives the taught run's route alone, by the landmarks of `building`.
Result<LandmarkMissionResult> drive_alone(const SimulationSetting& setting,
                                          const LandmarkCourseParams& params, const Building& building,
                                          const MapTruth& truth, const LandmarkMissionOptions& options,
                                          Progress& progress);

/// Somebody lifts the vehicle somewhere on its path and puts it down farther on or back, nearly as it stood.
/// @return nullopt if the path is too short, or too narrow to put it down
std::optional<ScenarioEvent> lift_on_route(const SimulationSetting& setting, const Path& path,
                                           const MapTruth& truth, double lift_m, std::uint64_t seed);

/// Takes a mission's run into the building's landmarks: C98 Algorithm 4.
void refine_by(const LandmarkMissionResult& mission, const VehicleDescription& vehicle,
               const LandmarkLearningParams& params, Building& building);

}  // namespace aisle
