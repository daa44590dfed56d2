#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "aisle/commands/drive.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/live_session/live_options.hpp"

namespace aisle {

/// A mission that a client requested, checked as far as possible without starting it.
struct LiveMission {
  using Work = std::function<Result<Outcome>(Console& console, const DriveOptions::KeyOperator& hand)>;

  std::string name;
  std::string session;  ///< name of the recorded session; empty: none
  bool is_driven_by_hand = false;
  bool drives = true;  ///< false: it only computes
  Work work;
};

/// The mission that mission/start requests.
/// @param T_world_vehicle  where the vehicle stands, if known
Result<LiveMission> live_mission(const LiveOptions& live, const nlohmann::json& arguments,
                                 const std::optional<Pose2>& T_world_vehicle);

/// The simulated vehicle that waits, and is driven by hand: the one that the server was started with, or alv.
std::string waiting_vehicle(const LiveOptions& live);

/// Driving by hand without recording.
LiveMission live_idling(const LiveOptions& live, const std::optional<Pose2>& T_world_vehicle);

}  // namespace aisle
