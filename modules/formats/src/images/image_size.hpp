#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace aisle {

struct ImageSize {
  std::uint64_t width_px = 0;
  std::uint64_t height_px = 0;
};

/// What an image file says of its size, before memory is taken for its pixels. No value: it is neither PNG,
/// JPEG, PBM, PGM, PPM, BMP, TIFF nor WebP, or its head makes no sense.
std::optional<ImageSize> stated_image_size(std::string_view bytes);

}  // namespace aisle
