#pragma once
/// Recordings made by others, which are no part of the repository.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace aisle {

/// Where such data is: $AISLE_DATA, or beside the repository.
inline std::filesystem::path real_data() {
  if (const char* set = std::getenv("AISLE_DATA")) return set;
  return std::filesystem::path(AISLE_SOURCE_DIR) / ".." / "shared" / "data";
}

}  // namespace aisle

/// Ends the test as skipped where `file` is absent.
#define AISLE_NEEDS(file)             \
  if (!std::filesystem::exists(file)) \
  GTEST_SKIP() << (file) << " is not here; AISLE_DATA may point to the data"
