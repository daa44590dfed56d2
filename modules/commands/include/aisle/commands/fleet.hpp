#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/fleet/fleet_client.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"

namespace aisle {

struct FleetOptions {
  std::filesystem::path building;
  std::string broker;  ///< mqtt://HOST[:PORT] or mqtts://HOST[:PORT]
  FleetIdentity identity;
  std::string user;
  std::filesystem::path password_file;  ///< its first line; empty: no password
  std::filesystem::path ca_file;        ///< who vouches for the broker; empty: those that the machine trusts
  std::size_t orders = 0;               ///< leaves after so many; 0: drives until it is ended
  std::filesystem::path lif;            ///< only writes the building's graph here

  std::filesystem::path connection;    ///< a robot's connection file; empty: drives in the simulator
  std::string world;                   ///< world or floor plan: file or shipped name
  std::optional<Pose2> T_world_start;  ///< simulated: it is put down here and not told; none: at home
  std::optional<MissionStart> told;    ///< where it is told that it is; none: unknown if it was put down
                                       ///< elsewhere, else at home
  std::string vehicle = "alv-scanner";
  std::string scenario;  ///< file or shipped name; empty: no faults
  std::uint64_t seed = 1;
  double rate = 1;  ///< simulated seconds per second
  bool force = false;
  ParameterSources parameters;
};

/// `aisle fleet BUILDING --broker URL --connect FILE` (or `--world WORLD`): a vehicle of a fleet, by VDA
/// 5050. With `--lif FILE`: writes the building's graph for the master control.
Result<Outcome> run_fleet(const FleetOptions& options, Console& console);

/// Every parameter of `aisle fleet` with its default.
Outcome fleet_parameters();

}  // namespace aisle
