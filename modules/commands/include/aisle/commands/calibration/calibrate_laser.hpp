#pragma once

#include <filesystem>
#include <vector>

#include "aisle/calibration/chessboard.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

struct CalibrateLaserOptions {
  std::filesystem::path camera;               ///< calibration of lens and mount
  std::vector<std::filesystem::path> images;  ///< each with the laser's stripe on something flat
  std::vector<double> walls_at_m;  ///< distance of the wall ahead, one for each image; none: a chessboard
                                   ///< on the wall tells where it is
  Chessboard board;
  std::filesystem::path out;  ///< empty: figures only
  bool force = false;
};

/// `aisle calibrate laser IMAGES`: the height of the laser plane, from its stripe.
Result<Outcome> run_calibrate_laser(const CalibrateLaserOptions& options, Console& console);

}  // namespace aisle
