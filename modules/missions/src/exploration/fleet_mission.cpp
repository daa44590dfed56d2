#include "aisle/missions/exploration/fleet_mission.hpp"

#include "aisle/missions/mission_recorder.hpp"

namespace aisle {
namespace {

/// Shows what the driver knows. It keeps no poses: a vehicle stays in its fleet for days.
class FleetMissionRecorder final : public MissionRecorder {
 public:
  FleetMissionRecorder(std::optional<SessionRecord>& session, const Vehicle& vehicle,
                       const TruthSource* truth, const FleetDriver& driver)
      : MissionRecorder(session, vehicle, truth), driver_(driver) {}

  using MissionRecorder::keep;

  Problems keep(const Decision& decision) override {
    if (!driver_.is_finding()) {
      const GuideNavigator& navigator = driver_.navigator();
      show_pose({navigator.T_map_vehicle()});
      show_plan(navigator.path());
      show_floor(navigator.floor().grid());
    }
    return MissionRecorder::keep(decision);
  }

 private:
  const FleetDriver& driver_;
};

}  // namespace

Result<MissionResult> drive_in_fleet(Vehicle& vehicle, const TruthSource* truth, FleetDriver& driver,
                                     std::optional<SessionRecord>& session, Progress& progress) {
  MissionResult result;
  FleetMissionRecorder record(session, vehicle, truth, driver);
  const Problems problems = drive_mission(vehicle, truth, driver, record, progress, result);
  driver.leave();
  if (!problems.empty()) return problems;
  return result;
}

}  // namespace aisle
