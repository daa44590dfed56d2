#include "aisle/live_session/live.hpp"

#include <fmt/format.h>

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "live_control.hpp"
#include "live_missions.hpp"
#include "live_operator.hpp"
#include "live_replay.hpp"
#include "live_request_handler.hpp"
#include "live_site.hpp"
#include "session_changes.hpp"

namespace aisle {
namespace {

/// How long clients may take to hear how a watched mission ended before the program is gone.
constexpr double kGoodbyeMax_s = 10;
constexpr std::chrono::milliseconds kGoodbyePoll{20};

DriveOptions::KeyOperator hand_of(LiveControl& control) {
  return [&control](const VehicleDescription&, const KeySpeeds&) -> Result<std::unique_ptr<Operator>> {
    return std::unique_ptr<Operator>(std::make_unique<LiveOperator>(control));
  };
}

void say_goodbye(LiveServer& server) {
  const SteadyClock clock;
  const double end_s = clock.now_s() + kGoodbyeMax_s;
  server.say_goodbye();
  while (server.clients() > 0 && clock.now_s() < end_s) std::this_thread::sleep_for(kGoodbyePoll);
}

/// A vehicle that drives one mission after the other, as clients request them.
class LiveRun {
 public:
  LiveRun(const LiveOptions& options, const Console& console, LiveSite& site)
      : options_(options),
        control_(console.progress, site.server(), site.mission_calls(), options.listening.rate,
                 [this](const ServiceCall& call) { take_call(call); }),
        watched_{control_, console.warn, &control_, [this] { return control_.take_goal_changes(); }} {
    control_.state().world = options.world;
    control_.state().vehicle =
        options.connection.empty() ? waiting_vehicle(options) : options.connection.string();
    control_.state().keeps_buildings = !options.listening.buildings.empty();
  }

  /// Runs until it is interrupted. The setting itself can be wrong only the first time.
  Problems run() {
    while (true) {
      const auto idled = idle();
      if (!idled && !control_.T_world_vehicle()) return idled.problems();
      if (auto mission = std::exchange(requested_mission_, std::nullopt)) drive(*mission);
      if (auto session = std::exchange(requested_replay_, std::nullopt)) replay(*session);
    }
  }

 private:
  Result<Outcome> idle() {
    LiveState& state = control_.state();
    state.mode = "idle";
    state.mission.clear();
    state.session.clear();
    state.is_driven_by_hand = true;
    control_.go_on();
    return work(live_idling(options_, control_.T_world_vehicle()));
  }

  void drive(const LiveMission& mission) {
    LiveState& state = control_.state();
    state.mode = mission.drives ? "mission" : "work";
    state.mission = mission.name;
    state.session = mission.session;
    state.is_driven_by_hand = mission.is_driven_by_hand;
    control_.begin();
    const auto outcome = work(mission);
    control_.end_mission(control_.was_stopped() ? live_end_stopped(mission.name)
                                                : live_end(mission.name, outcome));
  }

  /// Passes Interrupted on unless a client stopped the mission.
  Result<Outcome> work(const LiveMission& mission) {
    try {
      return mission.work(watched_, hand_of(control_));
    } catch (const Interrupted&) {
      if (!control_.was_stopped()) throw;
      return Outcome{.verb = mission.name, .ok = false};
    }
  }

  void replay(const std::filesystem::path& session) {
    LiveState& state = control_.state();
    state.mode = "replay";
    state.mission = "replay";
    state.session = session.filename();
    state.is_driven_by_hand = false;
    control_.begin();
    replay_ = std::make_unique<LiveReplay>(session, control_);
    const Problems problems = replay_->run();
    replay_.reset();
    control_.show_playback({});
    state.replay = nullptr;
    control_.set_rate(options_.listening.rate);
    control_.begin();  // the vehicle is not where the session ended
    if (!problems.empty()) state.last = live_end("replay", problems);
  }

  void take_call(const ServiceCall& call) {
    const std::string& service = call.service();
    if (replay_ && service.starts_with("replay/")) return replay_->take_call(call);
    if (control_.state().mode != "idle" || requested_mission_ || requested_replay_)
      return call.refuse("a mission is under way; mission/stop ends it");
    if (service == "mission/start" || service == "mission/go") return begin_mission(call);
    if (service == "replay/start") return begin_replay(call);
    if (service == "sessions/rename") return answer(call, rename_session(sessions(), call.arguments()));
    if (service == "sessions/delete") return answer(call, delete_session(sessions(), call.arguments()));
    call.refuse("nothing is being replayed");
  }

  void begin_mission(const ServiceCall& call) {
    nlohmann::json arguments = call.arguments();
    if (call.service() == "mission/go") arguments["mission"] = "go";
    auto mission = live_mission(options_, arguments, control_.T_world_vehicle());
    if (!mission) return call.refuse(to_string(mission.problems()));
    if (control_.state().is_emergency && mission->drives)
      return call.refuse("the emergency stop is not released");
    requested_mission_ = std::move(*mission);
    control_.hand().finish();
    call.answer(nlohmann::ordered_json::object());
  }

  const std::filesystem::path& sessions() const { return options_.listening.sessions; }

  static void answer(const ServiceCall& call, const Problems& problems) {
    problems.empty() ? call.answer(nlohmann::ordered_json::object()) : call.refuse(to_string(problems));
  }

  void begin_replay(const ServiceCall& call) {
    auto session = session_named(sessions(), call.arguments());
    if (!session) return call.refuse(to_string(session.problems()));
    requested_replay_ = std::move(*session);
    control_.hand().finish();
    call.answer(nlohmann::ordered_json::object());
  }

  const LiveOptions& options_;
  LiveControl control_;
  Console watched_;
  std::optional<LiveMission> requested_mission_;
  std::optional<std::filesystem::path> requested_replay_;
  std::unique_ptr<LiveReplay> replay_;
};

}  // namespace

Result<Outcome> run_live(const LiveOptions& options, Console& console,
                         const std::function<void(const std::string&)>& announce) {
  for (const std::filesystem::path& folder : {options.listening.sessions, options.listening.buildings}) {
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) return Problem{{folder.string()}, "cannot be made: " + error.message()};
  }
  const auto site = LiveSite::open(options.listening, console, announce);
  if (!site) return site.problems();
  LiveRun run(options, console, **site);
  return run.run();
}

Result<Outcome> run_watched(const LiveListening& listening, const std::string& verb, const WatchedWork& work,
                            Console& console, const std::function<void(const std::string&)>& announce) {
  const auto site = LiveSite::open(listening, console, announce);
  if (!site) return site.problems();
  LiveControl control(
      console.progress, (*site)->server(), (*site)->mission_calls(), listening.rate,
      [&](const ServiceCall& call) {
        call.refuse(fmt::format("`aisle {}` can only be watched; `aisle live` offers this service", verb));
      });
  control.state().mode = "mission";
  control.state().mission = verb;
  control.begin();
  Console watched{control, console.warn, &control, [&] { return control.take_goal_changes(); }};
  auto outcome = work(watched, hand_of(control));
  control.end_mission(live_end(verb, outcome));
  control.state().mode = "ended";
  control.serve(0);
  say_goodbye((*site)->server());
  return outcome;
}

}  // namespace aisle
