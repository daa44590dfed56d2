#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace aisle {

/// The first four bytes as a number, most significant first, as PNG writes it. There must be four.
inline std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

}  // namespace aisle
