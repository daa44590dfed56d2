#pragma once
/// Learning a way through a room, from a recorded or a simulated drive.

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

struct RoomLessonParams {
  RouteViewParams view;
  RoomLearningParams learning;

  void describe(FieldList& fields) {
    fields.group("view", view);
    fields.group("learning", learning);
  }
};

/// Looks at one cycle after another.
class RoomTripCollector {
 public:
  /// @param vehicle  with the camera `top`
  RoomTripCollector(const RoomLessonParams& params, const VehicleDescription& vehicle);

  void add(const Observation& observation);

  std::vector<RoomCycle> cycles;

 private:
  RoomLessonParams params_;
  VehicleDescription vehicle_;
  CameraDescription camera_;
  RouteView view_;
  bool has_patch_ = false;
};

/// All cycles of a session that was just opened. A session without pictures of `top` is a problem.
Result<std::vector<RoomCycle>> read_room_trip(const std::filesystem::path& session, SessionCycles& cycles,
                                              const RoomLessonParams& params, Progress& progress);

struct RoomLesson {
  Building building;  ///< with the route alone
  std::vector<Pose2> T_route_vehicle;
};

/// L96 section 2.
Result<RoomLesson> learn_room(const std::vector<RoomCycle>& cycles, const VehicleDescription& vehicle,
                              const std::string& route, const RoomLessonParams& params);

}  // namespace aisle
