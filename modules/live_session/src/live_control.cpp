#include "live_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/map_messages.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"
#include "live_arguments.hpp"
#include "live_goals.hpp"
#include "live_marks.hpp"

namespace aisle {
namespace {

constexpr double kStateEvery_s = 0.5;

const SessionTopic& state_topic() {
  static const SessionTopic topic{"/live/state", ros::String::kType, true};
  return topic;
}

std::string text_of(const nlohmann::json& arguments, const char* key) {
  const auto found = arguments.find(key);
  return found != arguments.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

std::vector<LiveService> control_services(ServiceMailbox& calls) {
  std::vector<LiveService> services;
  for (const char* name : {"mission/pause", "mission/resume", "mission/stop", "mission/emergency_release",
                           "mission/mark", "mission/finish", "mission/goals"})
    services.push_back({name, true, &calls});
  services.push_back({"mission/emergency_stop", false, &calls});
  services.push_back({"mission/trail", false, &calls});
  services.push_back({"mission/events", false, &calls});
  return services;
}

LiveControl::LiveControl(Progress& progress, LiveServer& server, ServiceMailbox& calls, double rate,
                         OtherCalls others)
    : progress_(progress),
      server_(server),
      calls_(calls),
      others_(std::move(others)),
      pace_(clock_, rate),
      hand_(server.drive()) {
  state_.rate = rate;
}

void LiveControl::begin() {
  server_.forget_latched();
  forget_past();
  begin_work();
}

void LiveControl::go_on() {
  trail_.go_on();
  begin_work();
}

void LiveControl::begin_work() {
  hand_.begin();
  pace_.rest();
  stamp_.reset();
  shall_end_ = shall_stop_ = was_stopped_ = false;
  building_.reset();
  goal_changes_.clear();
  state_.goals = nullptr;
  state_.goals_reached = 0;
  state_.map_origin = trail_.T_map_odom() ? pose_json(*trail_.T_map_odom()) : nlohmann::ordered_json();
  state_.is_paused = false;
  state_.stamp_s = 0;
  state_.task.clear();
  state_.done = state_.total = 0;
  reported_.clear();
  tell_state();
}

void LiveControl::take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  if (stamp_ != stamp) server_.take_time(stamp);
  stamp_ = stamp;
  server_.take(topic, stamp, cdr);
  take_past(topic, stamp, cdr);
  if (topic.name == "/session") show_map(stamp, cdr);
  if (topic.name == "/goals" && state_.mode == "mission") take_goals(cdr);
}

void LiveControl::take_goals(std::string_view goals_cdr) {
  const auto text = parse_cdr<ros::String>(goals_cdr);
  if (!text) return;
  const auto said = nlohmann::ordered_json::parse(text->data);
  if (said["goals"].empty()) return;  // a patrol
  state_.goals = said["goals"];
  state_.goals_reached = said["reached"];
}

void LiveControl::forget_past(ros::Stamp_ns first) {
  trail_.begin();
  events_.begin(first);
}

/// A waiting vehicle's time begins again: what it does is not of the mission.
void LiveControl::take_past(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  trail_.take(topic, cdr);
  if (state_.mode != "idle") events_.take(topic, stamp, cdr, trail_.p_map_vehicle());
}

void LiveControl::add_event(const char* kind, std::string_view text) {
  if (state_.mode == "mission") events_.add(stamp_.value_or(0), kind, text, trail_.p_map_vehicle());
}

void LiveControl::end_mission(nlohmann::ordered_json end) {
  add_event("end", end["ok"] == true ? "done" : "not done");
  state_.last = std::move(end);
}

/// Shows what the mission knows of the building before it begins.
void LiveControl::show_map(ros::Stamp_ns stamp, std::string_view session_cdr) {
  const auto text = parse_cdr<ros::String>(session_cdr);
  if (!text) return;
  const auto origin = parse_session_origin(text->data, "the session");
  if (!origin || origin->building.empty()) return;
  auto building = parse_building(origin->building, "building");
  if (!building) return;
  server_.take(map_topic(), stamp, map_cdr(stamp, *building));
  building_ = std::move(*building);
}

void LiveControl::report(std::string_view task, std::size_t done, std::size_t total) {
  progress_.report(task, done, total);
  state_.task = task;
  state_.done = done;
  state_.total = total;
  const bool is_cycle = total == 0 && stamp_;
  if (is_cycle) keep_pace();
  serve(0);
  while (state_.is_paused && !shall_stop_ && !shall_end_) {
    progress_.report(task, done, total);
    serve(kPausedPoll_s);
    pace_.rest();
  }
  stop_if_requested();
}

void LiveControl::set_rate(double rate) {
  pace_.set_rate(rate);
  state_.rate = rate;
}

void LiveControl::keep_pace() {
  state_.stamp_s = static_cast<double>(*stamp_) / 1e9;
  serve(pace_.wait_s(state_.stamp_s));
}

void LiveControl::serve(double duration_s) {
  const double end_s = clock_.now_s() + duration_s;
  while (!shall_stop_) {
    const double left_s = std::max(0.0, end_s - clock_.now_s());
    const auto call = calls_.wait(std::chrono::microseconds(static_cast<long>(left_s * 1e6)));
    if (call) {
      handle(*call);
    } else if (left_s <= 0) {
      break;
    }
  }
  tell_state();
}

void LiveControl::tell_state() {
  state_.lease_is_held = server_.lease_is_held();
  state_.distance_m = rounded(trail_.distance_m(), 2);
  state_.events = events_.count();
  std::string text = live_state_json(state_);
  const double now_s = clock_.now_s();
  LiveState still = state_;  // without what changes all the time
  still.stamp_s = still.distance_m = 0;
  still.done = 0;
  std::string news = live_state_json(still);
  if (news == reported_ && now_s - reported_s_ < kStateEvery_s) return;
  reported_ = std::move(news);
  reported_s_ = now_s;
  server_.take(state_topic(), stamp_.value_or(0), cdr_bytes(ros::String{std::move(text)}));
}

void LiveControl::stop_if_requested() {
  if (!std::exchange(shall_stop_, false)) return;
  was_stopped_ = true;
  throw Interrupted{};
}

void LiveControl::handle(const ServiceCall& call) {
  const std::string& service = call.service();
  if (service == "mission/pause") {
    if (!state_.is_paused) add_event("pause");
    hold();
  } else if (service == "mission/resume") {
    if (state_.is_emergency) return call.refuse("the emergency stop is not released");
    if (std::exchange(state_.is_paused, false)) add_event("resume");
  } else if (service == "mission/stop") {
    end(call.arguments().value("discard", nlohmann::json()) == true);
  } else if (service == "mission/trail") {
    return call.answer(trail_.json());
  } else if (service == "mission/events") {
    return tell_events(call);
  } else if (service == "mission/emergency_stop") {
    emergency_stop();
  } else if (service == "mission/emergency_release") {
    if (std::exchange(state_.is_emergency, false)) add_event("emergency_release");
    hand_.hold(false);
  } else if (service == "mission/mark") {
    return mark(call);
  } else if (service == "mission/goals") {
    return change_goals(call);
  } else if (service == "mission/finish") {
    if (!state_.is_driven_by_hand) return call.refuse("nobody drives by hand");
    hand_.finish();
  } else {
    return others_(call);
  }
  call.answer(nlohmann::ordered_json::object());
}

/// The vehicle stands where it is until a client resumes, drives by hand or ends the mission.
void LiveControl::emergency_stop() {
  if (!std::exchange(state_.is_emergency, true)) add_event("emergency_stop");
  hand_.hold(true);
  if (state_.mode == "mission" && !state_.is_driven_by_hand) hold();
}

/// The mission's time stands still; a vehicle that hears nothing new stands still, too.
void LiveControl::hold() {
  if (state_.is_paused) return;
  state_.is_paused = true;
  hand_.forget_command();
  static const SessionTopic command_topic{"/cmd_vel", ros::Twist::kType};
  if (stamp_) server_.take(command_topic, *stamp_, cdr_bytes(ros::Twist{}));
}

void LiveControl::end(bool discards) {
  if (state_.mode == "idle") return;
  const bool can_keep = state_.mode == "mission" && stamp_;
  if (discards || !can_keep) {
    shall_stop_ = true;
  } else {
    shall_end_ = true;
  }
}

void LiveControl::tell_events(const ServiceCall& call) const {
  LiveArguments arguments(call.arguments());
  const auto from = arguments.count("from", std::numeric_limits<std::uint32_t>::max());
  if (const Problems problems = arguments.problems(); !problems.empty())
    return call.refuse(to_string(problems));
  call.answer(events_.json(from.value_or(0)));
}

/// A held mission shows its new goals at once; the vehicle hears of them in its next cycle.
void LiveControl::change_goals(const ServiceCall& call) {
  if (state_.goals.is_null() || !building_) return call.refuse("no goals are driven to");
  LiveArguments arguments(call.arguments());
  const auto* const added = arguments.value("add");
  const auto removed = arguments.count("remove", kGoalsMax);
  Problems problems = arguments.problems();
  if (problems.empty() && (added != nullptr) == removed.has_value())
    problems.push_back({{"", 0, "add"}, "or remove is needed, and not both"});
  if (problems.empty()) problems = added != nullptr ? add_goal(*added) : remove_goal(*removed);
  if (!problems.empty()) return call.refuse(to_string(problems));
  const nlohmann::ordered_json said = {{"goals", state_.goals}, {"reached", state_.goals_reached}};
  events_.take_goals(stamp_.value_or(0), said.dump(), trail_.p_map_vehicle());
  call.answer({{"goals", state_.goals}});
}

Problems LiveControl::add_goal(const nlohmann::json& goal) {
  if (state_.goals.size() >= kGoalsMax)
    return {{{"", 0, "add"}, fmt::format("there are {} goals already", kGoalsMax)}};
  Problems problems;
  const std::string text = goal_in(goal, "add", problems);
  if (!problems.empty()) return problems;
  const auto known = goal_to(*building_, text);
  if (!known) return known.problems();
  // In the words of the vehicle, which soon says it again.
  state_.goals.push_back(nlohmann::ordered_json::parse(goals_json(*known, 0))["goals"][0]);
  goal_changes_.push_back({.added = text});
  return {};
}

Problems LiveControl::remove_goal(std::size_t number) {
  const Place where{"", 0, "remove"};
  if (number <= state_.goals_reached || number > state_.goals.size())
    return {{where, fmt::format("{} is not a goal that it still drives to", number)}};
  if (state_.goals.size() - state_.goals_reached == 1)
    return {{where, "it is the last goal; mission/stop ends the mission"}};
  state_.goals.erase(number - 1);
  goal_changes_.push_back({.removed = number});
  return {};
}

void LiveControl::mark(const ServiceCall& call) {
  const auto kind = mark_kind(text_of(call.arguments(), "kind"));
  if (!kind) return call.refuse("kind: must be 'place', 'stop', 'turning begins' or 'turning ends'");
  if (!state_.is_driven_by_hand) return call.refuse("marks are set while somebody drives by hand");
  const std::string label = text_of(call.arguments(), "label");
  constexpr std::size_t kLabelMax = 64;
  if (label.size() > kLabelMax) return call.refuse("label: more than 64 characters");
  hand_.mark({*kind, label});
  call.answer(nlohmann::ordered_json::object());
}

}  // namespace aisle
