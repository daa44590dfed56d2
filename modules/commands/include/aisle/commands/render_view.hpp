#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct RenderViewOptions {
  std::filesystem::path world;
  std::filesystem::path vehicle;         ///< empty: a standard camera 1 m above the floor
  std::string camera;                    ///< name of the vehicle's camera; empty: its first
  std::optional<Pose2> T_world_vehicle;  ///< none: the world's start
  double light = 1;                      ///< factor on all light
  bool lamps_off = false;
  bool laser = false;  ///< line lasers on
  std::uint64_t seed = 1;
  std::filesystem::path out;
  bool force = false;
  ParameterSources parameters;
};

/// `aisle sim render WORLD`: renders the image of a vehicle's camera at a given pose.
Result<Outcome> run_render_view(const RenderViewOptions& options, Console& console);

/// Every parameter of `aisle sim render` with its default; a vehicle file may override it.
Outcome render_view_parameters();

}  // namespace aisle
