#include "aisle/missions/exploration/exploration_mission.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "aisle/exploration/corridor_rules.hpp"
#include "aisle/formats/sessions/cdr.hpp"

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
class ExplorationMissionRecorder final : public MissionRecorder {
 public:
  ExplorationMissionRecorder(std::optional<SessionRecord>& session, const ExplorationRun& run,
                             const ExplorerNavigator& navigator, ExplorationMissionResult& result)
      : MissionRecorder(session, run, run.truth_source()), navigator_(navigator), result_(result) {}

  using MissionRecorder::keep;

  Problems keep(const Decision& decision) override {
    show_pose({navigator_.learner().T_map_vehicle()});
    show_plan(navigator_.path());
    show_transducer();
    show_floor(navigator_.learner().floor().grid());
    const bool is_new_scan = navigator_.learner().log().scans.size() > result_.T_world_scan.size();
    if (is_new_scan && T_world_vehicle() != nullptr) result_.T_world_scan.push_back(*T_world_vehicle());
    return MissionRecorder::keep(decision);
  }

 private:
  /// Only after a step of the transducer.
  void show_transducer() {
    const BuildingExplorer& explorer = navigator_.explorer();
    if (!is_watched() || explorer.steps().size() == steps_shown_) return;
    steps_shown_ = explorer.steps().size();
    static const SessionTopic topic{"/transducer", ros::String::kType, true};
    show(topic, cdr_bytes(ros::String{transducer_json(explorer)}));
  }

  std::size_t steps_shown_ = 0;
  const ExplorerNavigator& navigator_;
  ExplorationMissionResult& result_;
};

}  // namespace

Result<ExplorationMissionResult> drive_exploration(Vehicle& vehicle, const TruthSource* truth,
                                                   ExplorerNavigator& navigator,
                                                   std::optional<InterruptedRun> former,
                                                   std::optional<SessionRecord>& session,
                                                   Progress& progress) {
  ExplorationRun run(vehicle, truth, std::move(former));
  ExplorationMissionResult result;
  ExplorationMissionRecorder record(session, run, navigator, result);
  if (Problems problems = drive_mission(run, run.truth_source(), navigator, record, progress, result);
      !problems.empty())
    return problems;
  if (!run.problems().empty()) return run.problems();
  result.record = navigator.record();
  result.log = navigator.learner().log();
  return result;
}

}  // namespace aisle
