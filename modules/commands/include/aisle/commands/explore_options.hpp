#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/parameter_sources.hpp"
#include "aisle/exploration/building_explorer.hpp"
#include "aisle/formats/sessions/session_storage.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/missions/exploration/exploring_sensor.hpp"

namespace aisle {

struct ExploreOptions {
  std::filesystem::path connection;  ///< a robot's connection file; empty: explores in the simulator
  std::string world;                 ///< world or floor plan: file or shipped name
  double plan_pixel_m = 0.05;        ///< side of a plan's pixel, unless its file gives it
  ExploringSensor sensor = ExploringSensor::kScanner;
  std::string vehicle;              ///< empty: the shipped vehicle with this sensor
  std::string camera = "corridor";  ///< with kMarkers: the camera that sees the laser stripes
  std::string scenario;             ///< file or shipped name; empty: no faults
  ExploringOrder order = ExploringOrder::kRecommended;
  std::optional<Pose2> T_world_start;  ///< none: the world's start
  bool compares = false;               ///< explore by nearest frontier, too
  std::uint64_t seed = 1;
  std::filesystem::path out;      ///< output directory; empty: figures only
  std::filesystem::path session;  ///< directory of the session; empty: not recorded
  std::filesystem::path resumed;  ///< session of an interrupted run to continue; empty: none
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;  ///< of the session
  ParameterSources parameters;
};

}  // namespace aisle
