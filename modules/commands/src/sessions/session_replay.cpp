#include "aisle/commands/sessions/session_replay.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "aisle/formats/sessions/decision_text.hpp"
#include "aisle/formats/sessions/imported_session.hpp"
#include "aisle/formats/sessions/recorded_vehicle.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/missions/mission_recorder.hpp"
#include "aisle/missions/navigators.hpp"

namespace aisle {
namespace {

struct Difference {
  std::size_t cycle = 0;  ///< from 1
  double stamp_s = 0;
  std::string recorded;
  std::string replayed;
};

/// Takes the place of a session's recording: compares each decision with the recorded one.
class Comparison final : public MissionRecord {
 public:
  /// @param shown  session that shows the replay to a watcher; nullopt: not shown
  Comparison(const RecordedVehicle& vehicle, std::optional<SessionRecord>& shown)
      : vehicle_(vehicle), shown_(shown) {}

  Result<Observation> keep(Observation observation) override {
    ++cycle_;
    stamp_s_ = observation.stamp_s;
    if (shown_) {
      if (const auto kept = shown_->keep(observation); !kept) return kept.problems();
    }
    return observation;
  }

  Problems keep(const Decision& decision) override {
    if (shown_) (void)shown_->keep(decision);  // only shown, not recorded
    if (!vehicle_.recorded_decision()) return {};
    ++compared;
    // The texts are equal exactly if all bits are.
    std::string recorded = decision_text(*vehicle_.recorded_decision());
    std::string replayed = decision_text(decision);
    if (recorded == replayed) return {};
    ++different;
    if (!first) first = {cycle_, stamp_s_, std::move(recorded), std::move(replayed)};
    return {};
  }

  std::size_t compared = 0;
  std::size_t different = 0;
  std::optional<Difference> first;

 private:
  const RecordedVehicle& vehicle_;
  std::optional<SessionRecord>& shown_;
  std::size_t cycle_ = 0;
  double stamp_s_ = 0;
};

nlohmann::ordered_json difference_json(const Difference& difference) {
  return {{"cycle", difference.cycle},
          {"stamp_s", difference.stamp_s},
          {"recorded", nlohmann::ordered_json::parse(difference.recorded)},
          {"replayed", nlohmann::ordered_json::parse(difference.replayed)}};
}

std::string comparison_text(const Comparison& comparison, std::size_t cycles) {
  if (comparison.compared == 0)
    return fmt::format("{} cycles; an imported session has no decisions to compare with\n", cycles);
  if (!comparison.first)
    return fmt::format("all {} decisions are the recorded ones, bit for bit\n", comparison.compared);
  const Difference& first = *comparison.first;
  return fmt::format(
      "{} of {} decisions differ, first in cycle {} at {:.3f} s:\n  recorded {}\n  replayed {}\n",
      comparison.different, comparison.compared, first.cycle, first.stamp_s, first.recorded, first.replayed);
}

/// The navigator that drove, or another one with its default parameters and the same building and route.
SessionOrigin driver_of(const SessionOrigin& recorded, const std::string& navigator) {
  if (navigator.empty() || navigator == recorded.navigator) return recorded;
  SessionOrigin other = recorded;
  other.navigator = navigator;
  other.parameters.clear();
  return other;
}

/// Nobody decided in an imported session, so there is nothing to compare with; and a navigator that drives
/// needs to know how the vehicle moved, and what its camera is.
Problems check_imported(const SessionReplayOptions& options, const SessionCycles& cycles) {
  const SessionOrigin& origin = cycles.origin();
  const Place session{options.session.string()};
  if (options.navigator.empty() || options.navigator == kImportedNavigator) {
    return {{session,
             "was imported, so it has no decisions to compare with; --navigator NAME runs a navigator on "
             "it, aisle live shows it"}};
  }
  if (!origin.has_odometry) return {{session, "has no odometry, without which no navigator can decide"}};
  if (!origin.has_calibration) {
    const char* unknown = cycles.vehicle().cameras.empty() ? "its scanner's place" : "how its sensors sit";
    return {{session, fmt::format("tells nothing of {}: import it with --vehicle", unknown)}};
  }
  return {};
}

}  // namespace

Result<Outcome> run_session_replay(const SessionReplayOptions& options, Console& console) {
  auto cycles = SessionCycles::open(options.session);
  if (!cycles) return cycles.problems();
  const bool is_imported = cycles->origin().navigator == kImportedNavigator;
  if (is_imported) {
    if (Problems problems = check_imported(options, *cycles); !problems.empty()) return problems;
  }
  const SessionOrigin driver = driver_of(cycles->origin(), options.navigator);
  const auto navigator = make_navigator(driver, cycles->vehicle());
  if (!navigator) return navigator.problems();
  RecordedVehicle vehicle(std::move(*cycles));
  auto shown = show_session(vehicle.description(), driver, console.watcher);
  if (!shown) return shown.problems();
  Comparison comparison(vehicle, *shown);
  const auto end = run_mission(vehicle, **navigator, comparison, console.progress);
  if (!end) return end.problems();
  if (!vehicle.problems().empty()) return vehicle.problems();
  if (comparison.compared == 0 && !is_imported)
    return Problem{{options.session.string()}, "has no decision to compare with"};

  Outcome outcome{.verb = "replay", .ok = comparison.different == 0};
  outcome.figures = {{"navigator", driver.navigator},
                     {"cycles", end->cycles},
                     {"compared", comparison.compared},
                     {"different", comparison.different}};
  if (comparison.first) outcome.figures["first_difference"] = difference_json(*comparison.first);
  outcome.text = comparison_text(comparison, end->cycles);
  return outcome;
}

}  // namespace aisle
