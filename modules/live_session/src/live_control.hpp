#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "aisle/core/clock.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/live/live_server.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/vehicle/observation.hpp"
#include "live_events.hpp"
#include "live_hand.hpp"
#include "live_pace.hpp"
#include "live_state.hpp"
#include "live_trail.hpp"

namespace aisle {

/// Period at which a paused mission polls the requests of clients.
inline constexpr double kPausedPoll_s = 0.05;

/// The names of the services that LiveControl answers.
std::vector<LiveService> control_services(ServiceMailbox& calls);

/// Connects a mission to the live server: shows what the mission records, keeps pace with real time, and
/// serves the requests of clients once per cycle: pause, stop, marks.
class LiveControl final : public Progress, public MessageSink {
 public:
  /// Answers the calls of services that are not in control_services().
  using OtherCalls = std::function<void(const ServiceCall&)>;

  /// All references must outlive the control.
  LiveControl(Progress& progress, LiveServer& server, ServiceMailbox& calls, double rate, OtherCalls others);

  LiveState& state() { return state_; }
  LiveHand& hand() { return hand_; }

  /// Nothing has happened yet, and nothing was driven: a replay begins, or jumps to another time.
  /// @param first  stamp of the session's first message
  void forget_past(ros::Stamp_ns first = 0);
  /// A message that happened but is not shown.
  void take_past(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr);

  /// A mission begins: forgets what was shown of the previous one.
  void begin();
  /// The vehicle waits where the last mission left it: what was shown stays, as does where it stands on the
  /// map.
  void go_on();

  void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) override;
  void take_truth(const Pose2& T_world_vehicle) override { T_world_vehicle_ = T_world_vehicle; }

  /// Throws Interrupted if the work must stop, by Ctrl-C or by a client.
  void report(std::string_view task, std::size_t done, std::size_t total) override;
  /// A client has ended the mission; it keeps what it has.
  bool shall_end() const override { return shall_end_; }

  /// Whether a client stopped the work, so that nothing of it is kept.
  bool was_stopped() const { return was_stopped_; }
  /// The mission has ended; `end` is for `LiveState::last`.
  void end_mission(nlohmann::ordered_json end);
  /// Last true pose of the vehicle in the simulator.
  const std::optional<Pose2>& T_world_vehicle() const { return T_world_vehicle_; }

  /// How clients changed the goals of the mission since this was asked last.
  std::vector<GoalChange> take_goal_changes() { return std::exchange(goal_changes_, {}); }

  /// Serves requests for a duration [s]; at least those that have already arrived.
  void serve(double duration_s);
  /// Simulated time stands still for a while, then continues from the same value.
  void rest() { pace_.rest(); }
  double rate() const { return pace_.rate(); }
  void show_playback(const std::optional<Playback>& playback) { server_.show_playback(playback); }
  void set_rate(double rate);
  /// Sends the state to all clients if it changed or the last one is half a second old.
  void tell_state();

 private:
  void show_map(ros::Stamp_ns stamp, std::string_view session_cdr);
  void take_goals(std::string_view goals_cdr);
  void change_goals(const ServiceCall& call);
  Problems add_goal(const nlohmann::json& goal);
  Problems remove_goal(std::size_t number);
  void handle(const ServiceCall& call);
  void emergency_stop();
  void end(bool discards);
  void hold();
  void mark(const ServiceCall& call);
  void tell_events(const ServiceCall& call) const;
  void add_event(const char* kind, std::string_view text = {});
  void stop_if_requested();
  void begin_work();
  void keep_pace();

  Progress& progress_;
  LiveServer& server_;
  ServiceMailbox& calls_;
  OtherCalls others_;
  SteadyClock clock_;
  LivePace pace_;
  LiveHand hand_;
  LiveState state_;
  std::optional<ros::Stamp_ns> stamp_;
  std::string reported_;
  double reported_s_ = -1;
  LiveTrail trail_;
  LiveEvents events_;
  std::optional<Building> building_;  ///< that the mission drives in
  std::vector<GoalChange> goal_changes_;
  bool shall_end_ = false;
  bool shall_stop_ = false;
  bool was_stopped_ = false;
  std::optional<Pose2> T_world_vehicle_;
};

}  // namespace aisle
