#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/calibration/lens_calibration.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

struct CalibrateCameraOptions {
  std::vector<std::filesystem::path> images;
  Chessboard board;
  LensCalibrationParams lens;
  std::string camera_name = "camera";
  std::filesystem::path out;  ///< output directory; empty: figures only
  bool force = false;
};

/// `aisle calibrate camera IMAGES`: calibrates a camera's lens from images of a chessboard. A poor result is
/// an outcome that is not ok, with its figures. Too few images with a board are a problem.
Result<Outcome> run_calibrate_camera(const CalibrateCameraOptions& options, Console& console);

}  // namespace aisle
