#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/exploration/exploring_sensor.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/simulation/buildings/random_building.hpp"

namespace aisle {

struct TrialOptions {
  std::string method = "landmarks";
  std::uint64_t first_seed = 1;
  std::uint64_t last_seed = 1;
  std::vector<std::string> worlds;  ///< taken in turn; none: a building by chance for each seed
  double plan_pixel_m = 0.05;       ///< side of the pixels of a plan that a world is made of (explore)
  ExploringSensor sensor = ExploringSensor::kScanner;  ///< explore
  std::string vehicle;                                 ///< empty: the method's own: alv, or mini for sections
  std::string scenario;                                ///< empty: nothing goes wrong
  ParkingStrategy strategy = ParkingStrategy::kFrame;  ///< park
  int teachings = 1;                                   ///< of the path before it is driven alone (sections)
  int refinements = 0;  ///< runs after the first, each taken in before the next
  std::optional<double> speed_mps;
  bool in_reverse = false;
  bool close = false;                ///< turnings: two that are too close for the vehicle
  std::optional<double> lift_m;      ///< somewhere on its path the vehicle is put so much farther on or back
  std::optional<BuildingKind> kind;  ///< of buildings by chance; none: all in turn
  double noise_scale = 1;            ///< of the odometry's errors (explore)
  ParameterSources parameters;
};

/// `aisle trial METHOD --seeds A..B`: whole simulated missions, one a seed: taught, learned, driven alone,
/// refined. The outcome is ok if every mission arrived and touched nothing.
Result<Outcome> run_trial(const TrialOptions& options, Console& console);

/// Every parameter of `aisle trial` with its default.
Outcome trial_parameters();

}  // namespace aisle
