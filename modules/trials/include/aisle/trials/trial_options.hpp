#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/parameter_sources.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/missions/exploration/exploring_sensor.hpp"
#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/trials/trial_process.hpp"

namespace aisle {

struct TrialOptions {
  std::uint64_t seeds() const { return last_seed - first_seed + 1; }

  std::string method = "landmarks";
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 1;
  std::vector<std::string> worlds;  ///< taken in turn; empty: a random building for each seed
  double plan_pixel_m = 0.05;       ///< side of a plan's pixel, unless its file gives it (explore)
  ExploringSensor sensor = ExploringSensor::kScanner;  ///< explore
  std::string vehicle;   ///< empty: the method's default, alv or mini (sections)
  std::string scenario;  ///< file or shipped name; empty: no faults
  ParkingStrategy strategy = ParkingStrategy::kFrame;  ///< park
  int teachings = 1;     ///< taught runs before the route is driven autonomously (sections)
  int refinements = 0;   ///< runs after the first, each refining the building before the next (landmarks)
  std::string only;      ///< name of the one mission to run, such as "seed 5"; empty: all
  int jobs = 0;          ///< missions at a time; 0: one for each core, or one if processes share the trial
  TrialProcess process;  ///< of those that share the trial
  std::optional<BuildingKind> kind;  ///< of random buildings; none: all kinds in turn
  std::optional<double> speed_mps;
  std::optional<double> lift_m;  ///< kidnap: the vehicle is put so far ahead or back on its path (landmarks)
  double noise_scale = 1;        ///< factor on the odometry's errors (explore)
  bool starts_anywhere = false;  ///< at a random pose in place of the world's start (explore)
  bool in_reverse = false;
  bool close = false;         ///< turnings: pairs that are too close for the vehicle
  bool outdated_map = false;  ///< localise: in a map with 5 % of walls missing and furniture moved
  bool force = false;         ///< replace what `out` holds
  /// Keeps the missions, from which a trial goes on, and which processes share; empty: none.
  std::filesystem::path out;
  ParameterSources parameters;
  std::vector<std::string> words;  ///< the trial as given on the command line, without seeds, jobs and out
};

}  // namespace aisle
