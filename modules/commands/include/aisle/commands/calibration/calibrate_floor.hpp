#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "aisle/calibration/chessboard.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

struct CalibrateFloorOptions {
  std::filesystem::path camera;               ///< file with the calibration of the lens
  std::vector<std::filesystem::path> images;  ///< each with a board on the floor
  std::vector<BoardOnFloor> boards_at;        ///< one for each image
  Chessboard board;
  std::optional<std::filesystem::path> marks;  ///< file of marks, in addition to images or instead
  std::filesystem::path out;                   ///< output directory; empty: figures only
  bool force = false;
};

/// `aisle calibrate floor`: calibrates a camera's mount on the vehicle from boards or marks on the floor.
Result<Outcome> run_calibrate_floor(const CalibrateFloorOptions& options, Console& console);

}  // namespace aisle
