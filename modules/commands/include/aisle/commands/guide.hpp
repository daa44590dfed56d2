#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/sessions/session_storage.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"

namespace aisle {

struct GuideOptions {
  std::filesystem::path building;
  std::string place;  ///< `go`: the goal, a name or "x,y" in the map [m]; empty: the robot's viewer
  int rounds = 1;     ///< `patrol`
  std::filesystem::path connection;    ///< a robot's connection file; empty: drives in the simulator
  std::string world;                   ///< world or floor plan: file or shipped name
  double plan_pixel_m = 0.05;          ///< side of a plan's pixel, unless its file gives it
  std::optional<Pose2> T_world_start;  ///< simulated: it is put down here and not told; none: at home
  std::optional<MissionStart> told;    ///< where it is told that it is; none: unknown if it was put down
                                       ///< elsewhere, else at home
  std::string vehicle = "alv-scanner";
  std::string scenario;  ///< file or shipped name; empty: no faults
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< directory of the session; empty: not recorded
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;
  ParameterSources parameters;
};

/// `aisle go BUILDING PLACE --world WORLD` (or `--connect FILE`): drives to a place in an explored building,
/// from home or from wherever it finds itself. With a robot and without a place: to the goals of its viewer,
/// on /goal_pose.
Result<Outcome> run_go(const GuideOptions& options, Console& console);

/// `aisle patrol BUILDING --world WORLD --rounds N`: drives along all corridors, about once per round, and
/// home.
Result<Outcome> run_patrol(const GuideOptions& options, Console& console);

/// Every parameter of `aisle go` and `aisle patrol` with its default.
Outcome guide_parameters();

}  // namespace aisle
