#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct GuideOptions {
  std::filesystem::path building;
  std::string place;           ///< of `go`
  int rounds = 1;              ///< of `patrol`
  std::string world;           ///< or a plan that one is made of
  double plan_pixel_m = 0.05;  ///< side of its pixels where it does not say it
  std::string vehicle = "alv-scanner";
  std::string scenario;  ///< empty: nothing goes wrong
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< of the session; empty: none is kept
  bool force = false;
  ParameterSources parameters;
};

/// `aisle go BUILDING PLACE --world WORLD`: drives from home to a place of a building that was explored.
Result<Outcome> run_go(const GuideOptions& options, Console& console);

/// `aisle patrol BUILDING --world WORLD --rounds N`: drives all corridors about once a round, and home.
Result<Outcome> run_patrol(const GuideOptions& options, Console& console);

/// Every parameter of both with its default.
Outcome guide_parameters();

}  // namespace aisle
