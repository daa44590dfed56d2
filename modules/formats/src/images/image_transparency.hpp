#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace aisle {

/// One a pixel, row by row: 1 where an undamaged PNG, TIFF or WebP is not wholly opaque. Empty if it is
/// opaque everywhere or has another format: what 32-bit BMPs have in their fourth byte is seldom an alpha
/// channel.
std::vector<std::uint8_t> transparent_pixels(std::string_view bytes);

}  // namespace aisle
