#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/maps/room_route.hpp"

namespace aisle {

struct ParkOptions {
  std::filesystem::path building;
  std::string place;  ///< the name of the route that ends there
  std::string world;
  std::string vehicle;                      ///< empty: alv
  std::string scenario;                     ///< empty: nothing goes wrong
  std::optional<ParkingStrategy> strategy;  ///< a problem unless the route ends so
  std::optional<Pose2> T_world_start;       ///< else on the route, 3 m before its end
  bool in_reverse = false;                  ///< backs into the frame
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< of the session; empty: none is kept
  bool force = false;
  ParameterSources parameters;
};

/// `aisle park BUILDING PLACE --world WORLD`: parks at the end of a route that was taught, in the simulator.
Result<Outcome> run_park(const ParkOptions& options, Console& console);

/// Every parameter of `aisle park` with its default.
Outcome park_parameters();

}  // namespace aisle
