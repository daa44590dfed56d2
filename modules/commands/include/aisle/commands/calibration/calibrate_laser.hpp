#pragma once

#include <filesystem>
#include <vector>

#include "aisle/calibration/chessboard.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

struct CalibrateLaserOptions {
  std::filesystem::path camera;               ///< file with the calibration of lens and mount
  std::vector<std::filesystem::path> images;  ///< each with the laser stripe on a flat surface
  std::vector<double> walls_at_m;  ///< perpendicular distance to the wall ahead, one for each image; empty: a
                                   ///< chessboard on the wall gives it
  Chessboard board;
  std::filesystem::path out;  ///< output directory; empty: figures only
  bool force = false;
};

/// `aisle calibrate laser IMAGES`: calibrates height and slope of the laser plane from its stripe.
Result<Outcome> run_calibrate_laser(const CalibrateLaserOptions& options, Console& console);

}  // namespace aisle
