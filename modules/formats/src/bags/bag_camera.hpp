#pragma once

#include <optional>
#include <string>

#include "aisle/core/problem.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "bags/bag_streams.hpp"

namespace aisle {

/// The lens that a bag gives of the camera that took its images, within what a vehicle file may say.
/// @param topic   of the images; "rect" in its name: their distortion was taken out
/// @param warning with the place; says why a lens that the bag gives is not taken
std::optional<CameraIntrinsics> bag_lens(const BagImages& images, const std::string& topic, int width_px,
                                         int height_px, Problem warning, Problems& warnings);

/// How the camera sits, by the fixed transforms to the images' frame; a frame that looks to the sky is taken
/// for one whose x axis looks ahead. The height is that above base_footprint where there is one.
/// @param base  the vehicle's frame
std::optional<CameraMount> bag_mount(const TransformTree& transforms, const std::string& base,
                                     const std::string& frame, Problem warning, Problems& warnings);

}  // namespace aisle
