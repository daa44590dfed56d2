#pragma once
/// What a robot's messages say of a camera.

#include <optional>
#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/formats/bags/transform_tree.hpp"
#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// The lens of the camera that took some images, within what a vehicle file may say.
/// @param topic   of the images; "rect" in its name: their distortion was taken out
/// @param warning with the place; says why a lens that the messages give is not taken
std::optional<CameraIntrinsics> bag_lens(const ros::CameraInfo& info, const std::string& topic, int width_px,
                                         int height_px, Problem warning, Problems& warnings);

/// How the camera sits, by the fixed transforms to the images' frame; a frame that looks to the sky is taken
/// for one whose x axis looks ahead. The height is that above base_footprint where there is one.
/// @param base  the vehicle's frame
std::optional<CameraMount> bag_mount(const TransformTree& transforms, const std::string& base,
                                     const std::string& frame, Problem warning, Problems& warnings);

}  // namespace aisle
