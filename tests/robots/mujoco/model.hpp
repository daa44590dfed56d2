#pragma once

#include <string>

#include "vehicle.hpp"
#include "world.hpp"

namespace robots {

/// Physics run in steps of this length.
inline constexpr double kStep_s = 0.002;

/// Groups of geometry: what stands, what only cameras see, and the vehicle itself.
inline constexpr int kObstacleGroup = 0, kPanelGroup = 1, kVehicleGroup = 2;

struct ModelSettings {
  double wheel_friction = 1;
  int image_width_px = 64;  ///< the largest image that will be drawn
  int image_height_px = 64;
};

/// The world with a vehicle in it, as an MJCF model. Beside the vehicle's names it has a camera `top` that
/// sees all of the world from far above, x right and y up.
std::string model_of(const World& world, const Vehicle& vehicle, const Pose2& T_world_start,
                     const ModelSettings& settings);

}  // namespace robots
