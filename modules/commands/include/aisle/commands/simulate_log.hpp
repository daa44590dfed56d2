#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct SimulateLogOptions {
  std::filesystem::path world;
  std::uint64_t seed = 1;
  std::filesystem::path out;
  bool force = false;
  ParameterSources parameters;
};

/// `aisle sim log WORLD`: records the laser log of a simulated run along the world's tour.
Result<Outcome> run_simulate_log(const SimulateLogOptions& options, Console& console);

/// Every parameter of `aisle sim log` with its default.
Outcome simulate_log_parameters();

}  // namespace aisle
