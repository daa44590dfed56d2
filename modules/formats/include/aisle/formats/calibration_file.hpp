#pragma once
/// Calibrations as files: OpenCV YAML and ROS camera_info YAML. docs/formats/calibration.md specifies what is
/// read of either.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/calibration/camera_calibration.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// Reads either format; all problems of the file are reported together, each with its line and key. A lens
/// model that CameraModel cannot express (fisheye, rational, skew) is a problem. Keys of other programs are
/// passed over.
Result<CameraCalibration> read_calibration(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in problems.
Result<CameraCalibration> parse_calibration(std::string_view text, const std::string& name);

/// As OpenCV's FileStorage reads it.
std::string opencv_calibration_yaml(const CameraCalibration& calibration);

/// As ROS's camera_info tools read it.
std::string camera_info_yaml(const CameraCalibration& calibration);

}  // namespace aisle
