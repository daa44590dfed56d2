#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/exploration/exploring_sensor.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/exploration/building_explorer.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct ExploreOptions {
  std::string world;           ///< a world, or a plan that one is made of
  double plan_pixel_m = 0.05;  ///< side of its pixels where it does not say it
  ExploringSensor sensor = ExploringSensor::kScanner;
  std::string vehicle;              ///< empty: the shipped one with this sensor
  std::string camera = "corridor";  ///< that sees the markers' stripes
  std::string scenario;             ///< empty: nothing goes wrong
  ExploringOrder order = ExploringOrder::kRecommended;
  std::optional<Pose2> T_world_start;  ///< none: where the world says
  bool compares = false;               ///< drive by nearest frontier, too
  std::uint64_t seed = 1;
  std::filesystem::path out;      ///< empty: nothing is kept
  std::filesystem::path session;  ///< the run is recorded there; empty: it is not
  std::filesystem::path resumed;  ///< a recorded run that was interrupted, to go on with; empty: none
  bool force = false;
  ParameterSources parameters;
};

/// `aisle explore WORLD`: learns a building that nobody has shown, and comes home, in the simulator.
Result<Outcome> run_explore(const ExploreOptions& options, Console& console);

/// Every parameter of `aisle explore` with its default.
Outcome explore_parameters();

}  // namespace aisle
