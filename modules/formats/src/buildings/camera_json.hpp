#pragma once
/// The part "camera" of a building: the keys of a vehicle file's camera and its name.

#include <string>

#include "aisle/vehicle/camera_description.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string camera_json(const CameraDescription& camera);

CameraDescription read_camera(const JsonValue& value);

}  // namespace aisle
