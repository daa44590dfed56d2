#include "live_events.hpp"

#include <algorithm>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/decision_text.hpp"
#include "live_marks.hpp"

namespace aisle {
namespace {

template <class Value>
std::optional<Value> value_in(std::string_view cdr, std::optional<Value> (*parse)(const std::string&)) {
  const auto text = parse_cdr<ros::String>(cdr);
  return text ? parse(text->data) : std::nullopt;
}

std::string with_reason(const Decision& decision) {
  return decision.why.empty() ? decision.state : decision.state + ": " + decision.why;
}

}  // namespace

void LiveEvents::begin(ros::Stamp_ns first) {
  *this = {};
  first_ = first;
}

void LiveEvents::take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr,
                      const std::optional<Vec2>& p_map_vehicle) {
  if (topic.name == "/decision") {
    const auto decision = value_in(cdr, parse_decision);
    if (!decision || decision->state == state_) return;
    state_ = decision->state;
    add(stamp, "state", with_reason(*decision), p_map_vehicle);
  } else if (topic.name == "/operator") {
    const auto input = value_in(cdr, parse_operator);
    if (!input) return;
    for (const Mark& mark : input->marks) add(stamp, "mark", mark_text(mark), p_map_vehicle);
  } else if (topic.name == "/bumper") {
    const auto bumper = parse_cdr<ros::Bool>(cdr);
    const bool has_contact = bumper && bumper->data;
    if (has_contact && !has_contact_) add(stamp, "contact", "", p_map_vehicle);
    has_contact_ = has_contact;
  } else if (topic.name == "/goals") {
    if (const auto text = parse_cdr<ros::String>(cdr)) take_goals(stamp, text->data, p_map_vehicle);
  }
}

void LiveEvents::take_goals(ros::Stamp_ns stamp, const std::string& goals_json,
                            const std::optional<Vec2>& p_map_vehicle) {
  auto goals = parse_goals(goals_json);
  if (!goals) return;
  for (const GoalEvent& event : goal_events(goals_, *goals))
    add(stamp, event.kind, event.text, p_map_vehicle);
  goals_ = std::move(*goals);
}

void LiveEvents::add(ros::Stamp_ns stamp, const char* kind, std::string_view text,
                     const std::optional<Vec2>& p_map_vehicle) {
  events_.push_back({stamp, kind, std::string(text.substr(0, kTextMax)), p_map_vehicle});
  if (events_.size() <= kEventsMax) return;
  events_.pop_front();
  ++left_out_;
}

nlohmann::ordered_json LiveEvents::json(std::size_t from) const {
  auto events = nlohmann::ordered_json::array();
  const std::size_t first = std::clamp(from, left_out_, count());
  for (std::size_t i = first - left_out_; i < events_.size(); ++i) {
    const Event& event = events_[i];
    nlohmann::ordered_json json = {{"stamp_s", rounded(static_cast<double>(event.stamp - first_) / 1e9, 2)},
                                   {"kind", event.kind},
                                   {"text", event.text}};
    if (event.p_map) json["at_m"] = {rounded(event.p_map->x(), 2), rounded(event.p_map->y(), 2)};
    events.push_back(std::move(json));
  }
  return {{"from", first}, {"events", std::move(events)}};
}

}  // namespace aisle
