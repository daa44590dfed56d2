#include "aisle/formats/sessions/decision_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "aisle/formats/json_document.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

template <class Value, std::size_t count>
using Words = std::array<std::pair<Value, std::string_view>, count>;

constexpr Words<NavigatorStatus, 3> kStatusWords = {{{NavigatorStatus::kGoing, "going"},
                                                     {NavigatorStatus::kDone, "done"},
                                                     {NavigatorStatus::kFailed, "failed"}}};
constexpr Words<Mark::Kind, 4> kMarkWords = {{{Mark::Kind::kTurningBegins, "turning begins"},
                                              {Mark::Kind::kTurningEnds, "turning ends"},
                                              {Mark::Kind::kPlace, "place"},
                                              {Mark::Kind::kStop, "stop"}}};

template <class Value, std::size_t count>
std::string word_of(const Words<Value, count>& words, Value value) {
  for (const auto& [known, word] : words)
    if (known == value) return std::string(word);
  throw std::invalid_argument(fmt::format("{} is not a value of its enumeration", static_cast<int>(value)));
}

template <class Value, std::size_t count>
Value value_of(const Words<Value, count>& words, const Json& json) {
  for (const auto& [value, word] : words)
    if (json == word) return value;
  throw std::invalid_argument("unknown word");
}

/// JSON cannot express NaN and infinity, so they are written as text.
Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double number_of(const Json& json) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return kInfinity;
  if (json == "-inf") return -kInfinity;
  return json.get<double>();
}

Json command_json(const Command& command) {
  return {{"speed_mps", number(command.speed_mps)},
          {"steering_rad", number(command.steering_rad)},
          {"turn_rate_rad_s", number(command.turn_rate_rad_s)}};
}

Command command_of(const Json& json) {
  return {.speed_mps = number_of(json.at("speed_mps")),
          .steering_rad = number_of(json.at("steering_rad")),
          .turn_rate_rad_s = number_of(json.at("turn_rate_rad_s"))};
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The result of `read`; nullopt if it finds something else than it expects.
template <class Value>
std::optional<Value> parse(const std::string& text, Value (*read)(const Json&)) {
  const Result<Json> json = parse_json<Json>(text, "");
  if (!json) return std::nullopt;
  try {
    return read(*json);
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Decision decision_of(const Json& json) {
  return {.command = command_of(json.at("command")),
          .status = value_of(kStatusWords, json.at("status")),
          .state = json.at("state").get<std::string>(),
          .why = json.at("why").get<std::string>()};
}

Json goal_change_json(const GoalChange& change) {
  return change.added.empty() ? Json{{"remove", change.removed}} : Json{{"add", change.added}};
}

GoalChange goal_change_of(const Json& json) {
  if (json.contains("add")) return {.added = json.at("add").get<std::string>()};
  return {.removed = json.at("remove").get<std::size_t>()};
}

OperatorInput operator_of(const Json& json) {
  OperatorInput input;
  for (const char* key : {"requested", "wish"})  // release 0.1 wrote the latter
    if (json.contains(key)) input.requested = command_of(json.at(key));
  for (const Json& mark : json.at("marks"))
    input.marks.push_back({value_of(kMarkWords, mark.at("kind")), mark.at("label").get<std::string>()});
  if (json.contains("goals"))
    for (const Json& change : json.at("goals")) input.goal_changes.push_back(goal_change_of(change));
  input.quit = json.at("quit").get<bool>();
  input.gives_up = json.value("gives_up", false);
  return input;
}

}  // namespace

std::string decision_text(const Decision& decision) {
  return text_of({{"command", command_json(decision.command)},
                  {"status", word_of(kStatusWords, decision.status)},
                  {"state", decision.state},
                  {"why", decision.why}});
}

std::string operator_text(const OperatorInput& input) {
  Json json = Json::object();
  if (input.requested) json["requested"] = command_json(*input.requested);
  json["marks"] = Json::array();
  for (const Mark& mark : input.marks)
    json["marks"].push_back(Json{{"kind", word_of(kMarkWords, mark.kind)}, {"label", mark.label}});
  for (const GoalChange& change : input.goal_changes) json["goals"].push_back(goal_change_json(change));
  json["quit"] = input.quit;
  if (input.gives_up) json["gives_up"] = true;
  return text_of(json);
}

std::optional<Decision> parse_decision(const std::string& text) {
  return parse(text, decision_of);
}

std::optional<OperatorInput> parse_operator(const std::string& text) {
  return parse(text, operator_of);
}

}  // namespace aisle
