#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "aisle/maps/route.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Names of L96's three cameras, and what they look at.
inline constexpr const char* kFirstCamera = "top";      ///< near ahead
inline constexpr const char* kSecondCamera = "middle";  ///< far ahead
inline constexpr const char* kThirdCamera = "bottom";   ///< the corners of the route

/// @throws std::invalid_argument if the vehicle has none of that name
inline const CameraDescription& room_camera(const VehicleDescription& vehicle, const char* name) {
  if (const CameraDescription* camera = vehicle.camera(name)) return *camera;
  throw std::invalid_argument(std::string("the vehicle lacks the camera ") + name);
}

/// Height of the laser markers' light plane, if the first camera looks down on it; else nullopt.
inline std::optional<double> stripe_height_m(const VehicleDescription& vehicle) {
  if (!vehicle.laser_markers) return std::nullopt;
  const double height_m = vehicle.laser_markers->height_m;
  const bool is_above = room_camera(vehicle, kFirstCamera).mount.p_vehicle_camera.z() > height_m;
  return is_above ? std::optional(height_m) : std::nullopt;
}

/// Whether the route was taught with reversing between turnings.
inline bool backs_between_turnings(const Route& route) {
  const std::vector<PathPiece>& pieces = route.path.pieces();
  return std::any_of(pieces.begin(), pieces.end(), [](const PathPiece& p) { return p.arc.length_m < 0; });
}

/// The cameras needed to drive a route that was taught in a room.
inline std::vector<std::string> cameras_for(const Route& route) {
  if (route.room->parking == ParkingStrategy::kFrame) return {kFirstCamera, kSecondCamera, kThirdCamera};
  if (backs_between_turnings(route)) return {kFirstCamera, kThirdCamera};
  return {kFirstCamera};
}

}  // namespace aisle
