#include "exploration_mission.hpp"

#include <utility>

#include "aisle/simulation/simulated_vehicle.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

/// Keeps the mission's session and, beside it, where the vehicle really was.
class ExplorationMissionRecord final : public MissionRecord {
 public:
  ExplorationMissionRecord(std::optional<SessionRecord>& session, const ExplorationTrip& trip,
                           const ExplorerNavigator& navigator, ExplorationMissionResult& result)
      : session_(session), trip_(trip), navigator_(navigator), result_(result) {}

  Result<Observation> keep(Observation observation) override {
    if (!session_) return observation;
    auto kept = session_->keep(std::move(observation));
    if (!kept) return kept.problems();
    if (Problems problems = session_->keep_truth(kept->stamp_s, trip_.T_world_vehicle()); !problems.empty())
      return problems;
    return kept;
  }

  Problems keep(const Decision& decision) override {
    result_.T_world_vehicle.push_back(trip_.T_world_vehicle());
    if (navigator_.learner().log().scans.size() > result_.T_world_slice.size())
      result_.T_world_slice.push_back(trip_.T_world_vehicle());
    return session_ ? session_->keep(decision) : Problems{};
  }

 private:
  std::optional<SessionRecord>& session_;
  const ExplorationTrip& trip_;
  const ExplorerNavigator& navigator_;
  ExplorationMissionResult& result_;
};

}  // namespace

Result<ExplorationMissionResult> drive_exploration(const SimulationSetting& setting,
                                                   ExplorerNavigator& navigator, const Pose2& T_world_start,
                                                   std::uint64_t seed, std::optional<InterruptedTrip> former,
                                                   std::optional<SessionRecord>& session,
                                                   Progress& progress) {
  const Pose2 T_world_set_down = former ? former->T_world_vehicle.back() : T_world_start;
  SimulatedVehicle vehicle(setting.world, setting.vehicle, setting.scenario,
                           {.seed = seed, .T_world_start = T_world_set_down});
  ExplorationTrip trip(vehicle, std::move(former));
  ExplorationMissionResult result;
  TimedNavigator timed(navigator, result.cycle_s);
  ExplorationMissionRecord record(session, trip, navigator, result);
  auto end = run_mission(trip, timed, record, progress);
  if (!end) return end.problems();
  if (!trip.problems().empty()) return trip.problems();
  result.end = std::move(*end);
  result.record = navigator.record();
  result.log = navigator.learner().log();
  result.collisions = vehicle.truth().collisions;
  result.distance_m = trip.way_m();
  return result;
}

}  // namespace aisle
