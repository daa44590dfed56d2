#pragma once
/// Files that must be written exactly like this, and stay readable: `tests/golden`.

#include <filesystem>

namespace aisle {

inline const std::filesystem::path kGolden = std::filesystem::path(AISLE_SOURCE_DIR) / "tests" / "golden";

}  // namespace aisle
