#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct NavigateOptions {
  std::filesystem::path building;
  std::string world;
  std::string vehicle;   ///< empty: the method's own: alv, or mini for sections
  std::string scenario;  ///< empty: nothing goes wrong
  std::string method = "landmarks";
  std::string route;  ///< empty: the building's first
  bool in_reverse = false;
  bool and_back = false;  ///< sections: there, turned about, and home again
  std::optional<double> speed_mps;
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< of the session; empty: none is kept
  bool force = false;
  ParameterSources parameters;
};

/// `aisle navigate BUILDING --world WORLD`: drives a learned route alone, in the simulator.
Result<Outcome> run_navigate(const NavigateOptions& options, Console& console);

/// Every parameter of `aisle navigate` with its default.
Outcome navigate_parameters();

}  // namespace aisle
