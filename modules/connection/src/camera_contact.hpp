#pragma once

#include <cstddef>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/connection/seen_camera.hpp"
#include "robot_intake.hpp"

namespace aisle {

/// Whether a camera's images are to sit where /tf_static says.
bool needs_mount(const Connection& connection, const ConnectedCamera& camera);

/// What keeps a camera from being described yet; needs the intake's lock. Empty: nothing.
enum class CameraLack { kNothing, kImages, kStamps, kCalibration, kMount };
CameraLack lack_of(const Connection& connection, const VehicleDescription& vehicle, const RobotState& state,
                   std::size_t which);

/// A camera as its messages and the vehicle file have it. Its lens is that of CameraInfo, where one is read;
/// the file's, where it has the camera. Needs the intake's lock, and a camera that lacks nothing.
/// @param notes  what was doubtful
Result<SeenCamera> seen_camera(const Connection& connection, const VehicleDescription& vehicle,
                               RobotIntake& intake, std::size_t which, Problems& notes);

}  // namespace aisle
