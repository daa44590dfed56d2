#pragma once
/// Files as they must be written, and stay readable: `tests/golden`.

#include <filesystem>

namespace aisle {

inline const std::filesystem::path kGolden = std::filesystem::path(AISLE_SOURCE_DIR) / "tests" / "golden";

}  // namespace aisle
