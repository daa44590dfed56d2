#pragma once
/// Marks on the floor for `aisle calibrate floor`, one "u v x y" per line; see docs/formats/floor_marks.md.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/calibration/mount_calibration.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// All problems of the file are reported together, each with its line.
Result<std::vector<FloorMark>> read_floor_marks(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<std::vector<FloorMark>> parse_floor_marks(std::string_view text, const std::string& name);

}  // namespace aisle
