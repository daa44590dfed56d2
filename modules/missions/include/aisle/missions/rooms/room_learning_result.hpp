#pragma once
/// Learning a path through a room, from a recorded or a simulated drive.

#include <filesystem>
#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/learning/rooms/room_learning.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {

struct RoomLearnerParams {
  RouteViewParams view;
  RoomLearningParams learning;

  void describe(FieldList& fields) {
    fields.group("view", view);
    fields.group("learning", learning);
  }
};

/// Collects what is learned from, cycle by cycle.
class RoomRunCollector {
 public:
  /// @param vehicle  with the camera `top`
  RoomRunCollector(const RoomLearnerParams& params, const VehicleDescription& vehicle);

  void add(const Observation& observation);

  std::vector<RoomCycle> cycles;

 private:
  RoomLearnerParams params_;
  VehicleDescription vehicle_;
  CameraDescription camera_;
  RouteView view_;
  bool has_patch_ = false;
};

/// Reads all cycles of a session that was just opened. A session without images of `top` is a problem.
Result<std::vector<RoomCycle>> read_room_run(const std::filesystem::path& session, SessionCycles& cycles,
                                             const RoomLearnerParams& params, Progress& progress);

struct RoomLearningResult {
  Building building;  ///< with this route only
  std::vector<Pose2> T_route_vehicle;
};

/// L96 section 2.
Result<RoomLearningResult> learn_room(const std::vector<RoomCycle>& cycles, const VehicleDescription& vehicle,
                                      const std::string& route, const RoomLearnerParams& params);

}  // namespace aisle
