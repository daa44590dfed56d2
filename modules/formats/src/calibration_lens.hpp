#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// The lens model that ROS, OpenCV or kalibr call so; "none" and "" are plumb_bob. nullopt: not supported.
std::optional<LensModel> lens_model_named(std::string_view name);

/// ROS's name.
const char* name_of(LensModel model);

/// The coefficients in OpenCV's order, as many as the model has.
std::vector<double> distortion_coefficients(const CameraIntrinsics& lens);

/// Sets model and coefficients from a list in OpenCV's order.
/// @param stated  the model, if the file says one; otherwise the number of coefficients tells
/// @return what is wrong; empty: nothing
std::string set_distortion(CameraIntrinsics& lens, std::optional<LensModel> stated,
                           std::vector<double> coefficients);

}  // namespace aisle
