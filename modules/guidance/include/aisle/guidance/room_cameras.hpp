#pragma once

#include <stdexcept>
#include <string>

#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// L96's three cameras, by what they look at.
inline constexpr const char* kFirstCamera = "top";      ///< near ahead
inline constexpr const char* kSecondCamera = "middle";  ///< far ahead
inline constexpr const char* kThirdCamera = "bottom";   ///< the corners of the route

/// @throws std::invalid_argument if the vehicle has none of that name
inline const CameraDescription& room_camera(const VehicleDescription& vehicle, const char* name) {
  if (const CameraDescription* camera = vehicle.camera(name)) return *camera;
  throw std::invalid_argument(std::string("the vehicle lacks the camera ") + name);
}

}  // namespace aisle
