#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "aisle/calibration/chessboard.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

struct CalibrateFloorOptions {
  std::filesystem::path camera;               ///< calibration of the lens
  std::vector<std::filesystem::path> images;  ///< each with a board on the floor
  std::vector<BoardOnFloor> boards_at;        ///< one for each image
  Chessboard board;
  std::optional<std::filesystem::path> marks;  ///< besides or instead
  std::filesystem::path out;                   ///< empty: figures only
  bool force = false;
};

/// `aisle calibrate floor`: how a camera sits on the vehicle, from boards or marks on the floor.
Result<Outcome> run_calibrate_floor(const CalibrateFloorOptions& options, Console& console);

}  // namespace aisle
