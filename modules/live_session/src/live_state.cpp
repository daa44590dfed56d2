#include "live_state.hpp"

#include <filesystem>
#include <sstream>

namespace aisle {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The problem without the server's folders, which say nothing to clients.
std::string told(Problem problem) {
  problem.where.file = std::filesystem::path(problem.where.file).filename().string();
  return to_string(problem);
}

/// An outcome's text without the lines that name files of the server.
std::string told(const std::string& text) {
  std::string lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) {
    if (!line.starts_with("see ")) lines += line + "\n";
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
                      {"rate", state.rate},
                      {"task", state.task},
                      {"done", state.done},
                      {"total", state.total},
                      {"session", state.session},
                      {"keeps_buildings", state.keeps_buildings}};
  if (!state.map_origin.is_null()) json["map_origin"] = state.map_origin;
  if (!state.replay.is_null()) json["replay"] = state.replay;
  if (!state.last.is_null()) json["last"] = state.last;
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

OrderedJson live_end(const std::string& mission, const Result<Outcome>& outcome) {
  OrderedJson problems = OrderedJson::array();
  if (!outcome) {
    for (const Problem& problem : outcome.problems()) problems.push_back(told(problem));
  }
  return {{"mission", mission},
          {"ok", outcome.ok() && outcome->ok},
          {"text", outcome ? told(outcome->text) : ""},
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
