#include "aisle/guidance/mission.hpp"

#include <utility>

namespace aisle {
namespace {

/// Stops the vehicle when the mission ends, however it ends.
class StopAtEnd {
 public:
  explicit StopAtEnd(Vehicle& vehicle) : vehicle_(vehicle) {}
  ~StopAtEnd() { vehicle_.act({}); }
  StopAtEnd(const StopAtEnd&) = delete;
  StopAtEnd& operator=(const StopAtEnd&) = delete;

 private:
  Vehicle& vehicle_;
};

}  // namespace

Result<MissionEnd> run_mission(Vehicle& vehicle, Navigator& navigator, MissionRecord& record,
                               Progress& progress) {
  const StopAtEnd stop(vehicle);
  MissionEnd end;
  std::optional<double> start_s;
  for (auto sensed = vehicle.sense(); sensed; sensed = vehicle.sense()) {
    const Result<Observation> observation = record.keep(std::move(*sensed));
    if (!observation) return observation.problems();

    const Decision decision = navigator.step(*observation);
    vehicle.act(decision.command);
    if (const Problems problems = record.keep(decision); !problems.empty()) return problems;

    if (!start_s) start_s = observation->stamp_s;
    end = {.arrived = decision.status == NavigatorStatus::kDone,
           .state = decision.state,
           .why = decision.why,
           .cycles = end.cycles + 1,
           .duration_s = observation->stamp_s - *start_s};
    if (decision.status != NavigatorStatus::kGoing) return end;
    progress.report(decision.state, end.cycles, 0);
    if (progress.shall_end()) {
      end.why = kEndedByUser;
      return end;
    }
  }
  end.why = vehicle.end_reason();
  return end;
}

}  // namespace aisle
