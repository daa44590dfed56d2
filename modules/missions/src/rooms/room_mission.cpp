#include "aisle/missions/rooms/room_mission.hpp"

#include "aisle/guidance/rooms/room_cameras.hpp"

namespace aisle {
namespace {

/// Records the mission's session, and shows what the navigator sees.
class RoomMissionRecorder final : public MissionRecorder {
 public:
  RoomMissionRecorder(std::optional<SessionRecord>& session, const Vehicle& vehicle, const TruthSource* truth,
                      const RoomNavigator& navigator)
      : MissionRecorder(session, vehicle, truth), navigator_(navigator) {}

  using MissionRecorder::keep;

  Problems keep(const Decision& decision) override {
    show_pose({navigator_.pose()});
    if (is_watched() && image_camera() == kFirstCamera && navigator_.sight())
      show_overlay(overlay_of(navigator_.view(), *navigator_.sight()));
    return MissionRecorder::keep(decision);
  }

 private:
  const RoomNavigator& navigator_;
};

/// Lets the vehicle coast to a standstill: the truth of where it parked is known only then.
void await_standstill(Vehicle& vehicle, const TruthSource& truth) {
  constexpr int kUntilItStands = 20;
  for (int i = 0; i < kUntilItStands && truth.truth().speed_mps != 0; ++i) vehicle.sense();
}

}  // namespace

Result<RoomMissionResult> drive_room_mission(Vehicle& vehicle, const TruthSource* truth,
                                             RoomNavigator& navigator, std::optional<SessionRecord>& session,
                                             Progress& progress) {
  RoomMissionResult result;
  RoomMissionRecorder record(session, vehicle, truth, navigator);
  if (Problems problems = drive_mission(vehicle, truth, navigator, record, progress, result);
      !problems.empty())
    return problems;
  if (truth != nullptr) {
    await_standstill(vehicle, *truth);
    result.truth = truth->truth();
  }
  result.tries = navigator.parking_tries();
  result.has_seen_corner = navigator.has_seen_corner();
  result.odometry_correction = navigator.odometry_correction();
  result.is_confirmed = result.end.arrived && navigator.has_confirmed_place();
  return result;
}

}  // namespace aisle
