#include "live_state.hpp"

#include <filesystem>
#include <sstream>
#include <system_error>

namespace aisle {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The problem without the server's folders, which say nothing to clients.
std::string without_server_paths(Problem problem) {
  problem.where.file = std::filesystem::path(problem.where.file).filename().string();
  return to_string(problem);
}

/// The word, or the last part of a path of the server.
std::string without_server_path(const std::string& word) {
  const std::size_t end = word.find_last_not_of(".,;:");
  if (end == std::string::npos || word.find('/') == std::string::npos) return word;
  const std::filesystem::path path = word.substr(0, end + 1);
  std::error_code error;
  const bool is_path = path.is_absolute() || std::filesystem::exists(path, error);
  return is_path ? path.filename().string() + word.substr(end + 1) : word;
}

/// An outcome's text without the server's folders, and without the lines that say which file to see.
std::string without_server_paths(const std::string& text) {
  std::string lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) {
    if (line.starts_with("see ")) continue;
    std::istringstream words(line);
    std::string said;
    for (std::string word; words >> word;) said += (said.empty() ? "" : " ") + without_server_path(word);
    lines += said + "\n";
  }
  return lines;
}

}  // namespace

std::string live_state_json(const LiveState& state) {
  OrderedJson json = {{"mode", state.mode},
                      {"mission", state.mission},
                      {"world", state.world},
                      {"vehicle", state.vehicle},
                      {"paused", state.is_paused},
                      {"emergency", state.is_emergency},
                      {"driven_by_hand", state.is_driven_by_hand},
                      {"lease_held", state.lease_is_held},
                      {"stamp_s", state.stamp_s},
                      {"distance_m", state.distance_m},
                      {"events", state.events},
                      {"rate", state.rate},
                      {"task", state.task},
                      {"done", state.done},
                      {"total", state.total},
                      {"session", state.session},
                      {"keeps_buildings", state.keeps_buildings}};
  if (!state.map_origin.is_null()) json["map_origin"] = state.map_origin;
  if (!state.goals.is_null()) {
    json["goals"] = state.goals;
    json["goals_reached"] = state.goals_reached;
  }
  if (!state.replay.is_null()) json["replay"] = state.replay;
  if (!state.last.is_null()) json["last"] = state.last;
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

OrderedJson live_end(const std::string& mission, const Result<Outcome>& outcome) {
  OrderedJson problems = OrderedJson::array();
  if (!outcome) {
    for (const Problem& problem : outcome.problems()) problems.push_back(without_server_paths(problem));
  }
  return {{"mission", mission},
          {"ok", outcome.ok() && outcome->ok},
          {"text", outcome ? without_server_paths(outcome->text) : ""},
          {"figures", outcome ? outcome->figures : OrderedJson::object()},
          {"problems", std::move(problems)}};
}

OrderedJson live_end_stopped(const std::string& mission) {
  return {{"mission", mission},
          {"ok", false},
          {"text", "stopped"},
          {"figures", OrderedJson::object()},
          {"problems", OrderedJson::array()}};
}

}  // namespace aisle
