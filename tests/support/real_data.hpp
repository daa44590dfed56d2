#pragma once
/// Public recordings, which are not part of the repository.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace aisle {

/// The directory of such data: $AISLE_DATA, or next to the repository.
inline std::filesystem::path real_data() {
  if (const char* set = std::getenv("AISLE_DATA")) return set;
  return std::filesystem::path(AISLE_SOURCE_DIR) / ".." / "shared" / "data";
}

}  // namespace aisle

/// Skips the test if `file` is absent.
#define AISLE_NEEDS(file)             \
  if (!std::filesystem::exists(file)) \
  GTEST_SKIP() << (file) << " is not here; AISLE_DATA may point to the data"
