#include "exploration_mission.hpp"

#include "aisle/simulation/simulated_vehicle.hpp"
#include "simulated_record.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

/// Keeps the mission's session and, beside it, where the vehicle really was.
class ExplorationMissionRecord final : public SimulatedRecord {
 public:
  ExplorationMissionRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle,
                           const ExplorerNavigator& navigator, ExplorationMissionResult& result)
      : SimulatedRecord(session, vehicle), vehicle_(vehicle), navigator_(navigator), result_(result) {}

  using SimulatedRecord::keep;

  Problems keep(const Decision& decision) override {
    const Pose2& T_world_vehicle = vehicle_.truth().T_world_vehicle;
    result_.T_world_vehicle.push_back(T_world_vehicle);
    show_pose({navigator_.learner().T_map_vehicle()});
    show_plan(navigator_.path());
    if (navigator_.learner().log().scans.size() > result_.T_world_slice.size())
      result_.T_world_slice.push_back(T_world_vehicle);
    return SimulatedRecord::keep(decision);
  }

 private:
  const SimulatedVehicle& vehicle_;
  const ExplorerNavigator& navigator_;
  ExplorationMissionResult& result_;
};

}  // namespace

Result<ExplorationMissionResult> drive_exploration(const SimulationSetting& setting,
                                                   ExplorerNavigator& navigator, const Pose2& T_world_start,
                                                   std::uint64_t seed, std::optional<SessionRecord>& session,
                                                   Progress& progress) {
  SimulatedVehicle vehicle(setting.world, setting.vehicle, setting.scenario,
                           {.seed = seed, .T_world_start = T_world_start});
  ExplorationMissionResult result;
  TimedNavigator timed(navigator, result.cycle_s);
  ExplorationMissionRecord record(session, vehicle, navigator, result);
  auto end = run_mission(vehicle, timed, record, progress);
  if (!end) return end.problems();
  result.end = std::move(*end);
  result.record = navigator.record();
  result.log = navigator.learner().log();
  result.collisions = vehicle.truth().collisions;
  result.distance_m = vehicle.truth().way_m;
  return result;
}

}  // namespace aisle
