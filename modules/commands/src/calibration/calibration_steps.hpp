#pragma once
/// What the verbs of `aisle calibrate` share.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "aisle/calibration/camera_calibration.hpp"
#include "aisle/calibration/chessboard.hpp"
#include "aisle/calibration/verdict.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/report/residual_picture.hpp"

namespace aisle {

/// Rounds a figure to nine significant digits, so that it prints shortly.
double nine_digits(double value);

nlohmann::ordered_json verdict_figures(const CalibrationVerdict& verdict);

/// "verdict: usable\n  - reason\n..."
std::string verdict_text(const CalibrationVerdict& verdict);

/// Reads an image. An image of another size than the calibration's is a problem.
Result<Image> read_calibrated_image(const std::filesystem::path& path, const CameraCalibration& calibration);

/// Opens the directory for a calibration's files before the work starts; nullopt if `directory` is empty.
Result<std::optional<OutputDirectory>> open_calibration_directory(const std::filesystem::path& directory,
                                                                  bool force, bool with_residuals);

/// The calibration in both layouts (OpenCV, ROS), and the picture of its residuals.
std::vector<OutputFile> calibration_files(const CameraCalibration& calibration,
                                          const std::optional<ResidualPicture>& residuals);

}  // namespace aisle
