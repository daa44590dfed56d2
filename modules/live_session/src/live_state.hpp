#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "aisle/commands/outcome.hpp"

namespace aisle {

/// What /live/state reports, see docs/reference/live-server.md.
struct LiveState {
  std::string mode = "idle";
  std::string mission;
  std::string world;
  std::string vehicle;
  bool is_paused = false;
  bool is_emergency = false;
  bool is_driven_by_hand = false;
  bool lease_is_held = false;
  double stamp_s = 0;
  double distance_m = 0;
  std::size_t events = 0;  ///< of the mission
  double rate = 1;
  std::string task;
  std::size_t done = 0;
  std::size_t total = 0;
  std::string session;
  bool keeps_buildings = false;       ///< there is a folder for what missions learn
  nlohmann::ordered_json map_origin;  ///< null: the map is the mission's own
  nlohmann::ordered_json goals;       ///< of the mission, in order; null: it has none
  std::size_t goals_reached = 0;      ///< so many of them, from the first on
  nlohmann::ordered_json replay;      ///< null: none
  nlohmann::ordered_json last;        ///< null: none
};

std::string live_state_json(const LiveState& state);

/// How a mission ended, for `LiveState::last`.
nlohmann::ordered_json live_end(const std::string& mission, const Result<Outcome>& outcome);
nlohmann::ordered_json live_end_stopped(const std::string& mission);

}  // namespace aisle
