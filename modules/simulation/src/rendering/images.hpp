#pragma once

#include <cstdint>

#include "rendering/texture.hpp"

namespace aisle {

/// Unevenness around 0.5 of several sizes, as of plaster or stains.
Texture::Image clouds(std::uint64_t seed, int coarsest_cells);

/// Grain around 0.5, as of carpet and terrazzo.
Texture::Image grain(std::uint64_t seed);

/// A printed poster on white paper: a title, images, blocks of text.
Texture::Image poster_print(std::uint64_t seed);

/// Sheets of paper pinned to cork.
Texture::Image pinned_sheets(std::uint64_t seed);

}  // namespace aisle
