#pragma once

#include <filesystem>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "aisle/vehicle/camera_description.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A run as landmarks are learned from it.
struct LandmarkRun {
  VehicleDescription vehicle;
  CameraDescription camera;
  std::vector<LandmarkCycle> cycles;
  std::vector<Pose2>
      T_world_vehicle;  ///< the truth of each cycle, if the run was simulated: for evaluation only
};

/// The camera that looks along corridors: the one of that name, else the first. The vehicle must have one.
const CameraDescription& corridor_camera(const VehicleDescription& vehicle);

/// Finds the landmarks in one cycle after another.
class LandmarkRunCollector {
 public:
  LandmarkRunCollector(const LandmarkSightingParams& params, const VehicleDescription& vehicle);

  void add(const Observation& observation);

  LandmarkRun run;

 private:
  LandmarkDetector detector_;
};

/// A recorded run: all cycles of a session that was just opened. A session without images of that camera
/// is a problem.
Result<LandmarkRun> read_landmark_run(const std::filesystem::path& session, SessionCycles& cycles,
                                      const LandmarkSightingParams& params, Progress& progress);

}  // namespace aisle
