#pragma once
/// A route from teaching to autonomous driving, in simulation: a person drives it, it is learned, the vehicle
/// drives it.

#include <cstdint>
#include <optional>

#include "aisle/commands/simulation_setting.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/evaluation/landmarks/landmark_evaluation.hpp"
#include "aisle/missions/landmarks/landmark_learning_result.hpp"
#include "aisle/missions/landmarks/landmark_mission.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"
#include "aisle/simulation/operators/scripted_operator.hpp"

namespace aisle {

struct LandmarkCourseParams {
  LandmarkLearnerParams learner;
  LandmarkNavigatorParams navigator;
  ScriptedOperatorParams person;

  void describe(FieldList& fields);
};

/// Removes all cameras but the one that landmarks are seen with. A vehicle without a camera is a problem.
Problems keep_corridor_camera(SimulationSetting& setting);

/// A scripted person drives the world's tour; the run is recorded in memory.
/// @return nullopt: the person did not get through
Result<std::optional<LandmarkRun>> teach_run(const SimulationSetting& setting,
                                             const LandmarkCourseParams& params, std::uint64_t seed,
                                             Progress& progress);

/// The vehicle, put down near its start, drives the taught route autonomously, by the landmarks of
/// `building`.
/// @param in_reverse  drives the return path
Result<JudgedLandmarkMission> drive_alone(const SimulationSetting& setting,
                                          const LandmarkCourseParams& params, const Building& building,
                                          const MapTruth& truth, std::uint64_t seed, bool in_reverse,
                                          Progress& progress);

/// A kidnapping: the vehicle is lifted somewhere on its path and put down `lift_m` ahead or back, with nearly
/// the same heading.
/// @return nullopt if the path is too short, or too narrow to put it down
std::optional<ScenarioEvent> lift_on_route(const SimulationSetting& setting, const Path& path,
                                           const MapTruth& truth, double lift_m, std::uint64_t seed);

/// Refines the building's landmarks with a mission's run: C98 Algorithm 4.
void refine_by(const LandmarkMissionResult& mission, const VehicleDescription& vehicle,
               const LandmarkLearningParams& params, Building& building);

}  // namespace aisle
