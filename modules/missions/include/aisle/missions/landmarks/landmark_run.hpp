#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "aisle/vehicle/camera_description.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A place that the person who taught a run has named where the vehicle was.
struct NamedCycle {
  std::size_t cycle = 0;
  std::string name;
};

/// A run that landmarks are learned from.
struct LandmarkRun {
  VehicleDescription vehicle;
  CameraDescription camera;
  std::vector<LandmarkCycle> cycles;
  std::vector<NamedCycle> places;
  std::vector<Pose2> T_world_vehicle;  ///< true poses of a simulated run, one per cycle: for evaluation only
};

/// The camera that looks along corridors: the one named "corridor", else the first. The vehicle must have a
/// camera.
const CameraDescription& corridor_camera(const VehicleDescription& vehicle);

/// Detects the landmarks of a run, cycle by cycle.
class LandmarkRunCollector {
 public:
  LandmarkRunCollector(const LandmarkSightingParams& params, const VehicleDescription& vehicle);

  void add(const Observation& observation);

  LandmarkRun run;

 private:
  LandmarkDetector detector_;
};

/// Reads a recorded run: all cycles of a session that was just opened. A session without images of the
/// corridor camera is a problem.
Result<LandmarkRun> read_landmark_run(const std::filesystem::path& session, SessionCycles& cycles,
                                      const LandmarkSightingParams& params, Progress& progress);

}  // namespace aisle
