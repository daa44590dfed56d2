#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "aisle/formats/images/image_file.hpp"

namespace aisle {

/// Pixels of 2 or 4 bytes, the last of them alpha (255: opaque), as an image and what shows through it.
TransparentImage apart_from_alpha(std::span<const std::uint8_t> pixels, int width_px, int height_px,
                                  int channels);
/// The other way: 255 for what is opaque, 0 for what is not.
std::vector<std::uint8_t> with_alpha(const Image& image, std::span<const std::uint8_t> transparent);

}  // namespace aisle
