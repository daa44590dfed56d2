#include "exploration/exploration_mission.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "aisle/exploration/corridor_rules.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "simulated_record.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

/// The transducer's last transition and its stack, bottom first: /transducer of
/// docs/reference/live-server.md.
std::string transducer_json(const BuildingExplorer& explorer) {
  const TransducerTable& table = corridor_rules();
  auto stack = nlohmann::ordered_json::array();
  for (const Symbol symbol : explorer.transducer().stack()) stack.push_back(table.stack[symbol]);
  const TransducerStep& last = explorer.steps().back();
  return nlohmann::ordered_json{
      {"state", last.state}, {"input", last.input}, {"output", last.output}, {"stack", std::move(stack)}}
      .dump();
}

/// Records the mission's session and the true poses of the vehicle.
class ExplorationMissionRecord final : public SimulatedRecord {
 public:
  ExplorationMissionRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle,
                           const ExplorationRun& run, const ExplorerNavigator& navigator,
                           ExplorationMissionResult& result)
      : SimulatedRecord(session, vehicle),
        session_(session),
        run_(run),
        navigator_(navigator),
        result_(result) {}

  Result<Observation> keep(Observation observation) override {
    if (!run_.was_interrupted() || !session_) return SimulatedRecord::keep(std::move(observation));
    auto kept = session_->keep(std::move(observation));
    if (!kept) return kept.problems();
    if (Problems problems = session_->keep_truth(kept->stamp_s, run_.T_world_vehicle()); !problems.empty())
      return problems;
    return kept;
  }

  Problems keep(const Decision& decision) override {
    const Pose2& T_world_vehicle = run_.T_world_vehicle();
    result_.T_world_vehicle.push_back(T_world_vehicle);
    if (!run_.was_interrupted()) show_all();
    if (navigator_.learner().log().scans.size() > result_.T_world_scan.size())
      result_.T_world_scan.push_back(T_world_vehicle);
    return SimulatedRecord::keep(decision);
  }

 private:
  void show_all() {
    show_pose({navigator_.learner().T_map_vehicle()});
    show_plan(navigator_.path());
    show_transducer();
    show_floor(navigator_.learner().floor().grid());
  }

  /// Only after a step of the transducer.
  void show_transducer() {
    const BuildingExplorer& explorer = navigator_.explorer();
    if (!is_watched() || explorer.steps().size() == steps_shown_) return;
    steps_shown_ = explorer.steps().size();
    static const SessionTopic topic{"/transducer", ros::String::kType, true};
    show(topic, cdr_bytes(ros::String{transducer_json(explorer)}));
  }

  std::optional<SessionRecord>& session_;
  const ExplorationRun& run_;
  std::size_t steps_shown_ = 0;
  const ExplorerNavigator& navigator_;
  ExplorationMissionResult& result_;
};

}  // namespace

Result<ExplorationMissionResult> drive_exploration(const SimulationSetting& setting,
                                                   ExplorerNavigator& navigator, const Pose2& T_world_start,
                                                   std::uint64_t seed, std::optional<InterruptedRun> former,
                                                   std::optional<SessionRecord>& session,
                                                   Progress& progress) {
  const Pose2 T_world_set_down = former ? former->T_world_vehicle.back() : T_world_start;
  SimulatedVehicle vehicle(setting.world, setting.vehicle, setting.scenario,
                           {.seed = seed, .T_world_start = T_world_set_down});
  ExplorationRun run(vehicle, std::move(former));
  ExplorationMissionResult result;
  TimedNavigator timed(navigator, result.cycle_s);
  ExplorationMissionRecord record(session, vehicle, run, navigator, result);
  auto end = run_mission(run, timed, record, progress);
  if (!end) return end.problems();
  if (!run.problems().empty()) return run.problems();
  result.end = std::move(*end);
  result.record = navigator.record();
  result.log = navigator.learner().log();
  result.collisions = vehicle.truth().collisions;
  result.distance_m = run.path_m();
  return result;
}

}  // namespace aisle
