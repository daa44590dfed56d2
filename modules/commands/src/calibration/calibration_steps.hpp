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

/// Numbers of a calibration with nine digits, so that they print shortly.
double nine_digits(double value);

nlohmann::ordered_json verdict_figures(const CalibrationVerdict& verdict);

/// "verdict: usable\n  - reason\n..."
std::string verdict_text(const CalibrationVerdict& verdict);

/// An image; a problem also if it has another size than the calibration holds for.
Result<Image> read_calibrated_image(const std::filesystem::path& path, const CameraCalibration& calibration);

/// The directory for a calibration's files, checked before the work; none was asked for: nullopt.
Result<std::optional<OutputDirectory>> open_calibration_directory(const std::filesystem::path& directory,
                                                                  bool force, bool with_residuals);

/// The calibration in both layouts, and the image of its residuals.
std::vector<OutputFile> calibration_files(const CameraCalibration& calibration,
                                          const std::optional<ResidualPicture>& residuals);

}  // namespace aisle
