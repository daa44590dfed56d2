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
  std::filesystem::path vehicle;         ///< empty: an ordinary camera 1 m above the floor
  std::string camera;                    ///< of the vehicle; empty: its first
  std::optional<Pose2> T_world_vehicle;  ///< else the world's start
  double light = 1;
  bool lamps_off = false;
  bool laser = false;
  std::uint64_t seed = 1;
  std::filesystem::path out;
  bool force = false;
  ParameterSources parameters;
};

/// `aisle sim render WORLD`: the image that a vehicle's camera takes at a place.
Result<Outcome> run_render_view(const RenderViewOptions& options, Console& console);

/// Every parameter of `aisle sim render` with its default; a vehicle file may say otherwise.
Outcome render_view_parameters();

}  // namespace aisle
