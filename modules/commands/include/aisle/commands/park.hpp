#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/sessions/session_storage.hpp"
#include "aisle/maps/room_route.hpp"

namespace aisle {

struct ParkOptions {
  std::filesystem::path building;
  std::string place;                 ///< name of the route that ends there
  std::filesystem::path connection;  ///< connection file of a robot; empty: simulated
  std::string world;
  std::string vehicle;                      ///< empty: alv
  std::string scenario;                     ///< file or shipped name; empty: no faults
  std::optional<ParkingStrategy> strategy;  ///< if set, it is a problem if the route was taught with another
  std::optional<Pose2> T_world_start;       ///< none: on the route, 3 m before its end
  bool in_reverse = false;                  ///< back into the painted frame
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< directory of the session; empty: not recorded
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;
  ParameterSources parameters;
};

/// `aisle park BUILDING PLACE --world WORLD`: parks at the end of a taught route, in the
/// simulator or with a robot.
Result<Outcome> run_park(const ParkOptions& options, Console& console);

/// Every parameter of `aisle park` with its default.
Outcome park_parameters();

}  // namespace aisle
