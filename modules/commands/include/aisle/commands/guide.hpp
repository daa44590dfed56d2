#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/sessions/session_storage.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"

namespace aisle {

struct GuideOptions {
  std::filesystem::path building;
  /// `go`: the goals in order, names, "x,y" in the map [m] or "x,y,heading_deg"; none: the robot's viewer
  std::vector<std::string> places;
  int rounds = 1;                      ///< `patrol`
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

/// `aisle go BUILDING PLACE... --world WORLD` (or `--connect FILE`): drives to places in an explored
/// building, one after the other, from home or from wherever it finds itself. It ends at the first that it
/// cannot reach. With a robot and without a place: to the goals of its viewer, on /goal_pose.
Result<Outcome> run_go(const GuideOptions& options, Console& console);

/// `aisle patrol BUILDING --world WORLD --rounds N`: drives along all corridors, about once per round, and
/// home.
Result<Outcome> run_patrol(const GuideOptions& options, Console& console);

/// Every parameter of `aisle go` and `aisle patrol` with its default.
Outcome guide_parameters();

}  // namespace aisle
