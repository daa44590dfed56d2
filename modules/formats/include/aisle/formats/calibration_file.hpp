#pragma once
/// Calibration files: OpenCV YAML, ROS camera_info YAML and kalibr's camchain. docs/formats/calibration.md
/// lists the keys that are read from each.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/calibration/camera_calibration.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// Reads any of these; all problems of the file are reported together, each with its line and key. What
/// CameraModel cannot express (other lens models, thin prisms, skew) is a problem, and so is a file of
/// several cameras. Keys of other programs are ignored.
Result<CameraCalibration> read_calibration(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<CameraCalibration> parse_calibration(std::string_view text, const std::string& name);

/// The text that OpenCV's FileStorage reads.
std::string opencv_calibration_yaml(const CameraCalibration& calibration);

/// The text that ROS's camera_info tools read.
std::string camera_info_yaml(const CameraCalibration& calibration);

}  // namespace aisle
