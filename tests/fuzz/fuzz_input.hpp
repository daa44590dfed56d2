#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace aisle {

inline std::string_view fuzz_text(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// Ends the run as a crash, because a reader broke its promise.
inline void require(bool promise) {
  if (!promise) __builtin_trap();
}

}  // namespace aisle
