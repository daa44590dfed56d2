#pragma once

#include <cstdint>

#include "rendering/texture.hpp"

namespace aisle {

/// Unevenness around 0.5 of several sizes, as of plaster or stains.
Texture::Picture clouds(std::uint64_t seed, int coarsest_cells);

/// Grain around 0.5, as of carpet and terrazzo.
Texture::Picture grain(std::uint64_t seed);

/// A printed poster on white paper: a title, pictures, blocks of text.
Texture::Picture poster_print(std::uint64_t seed);

/// Sheets of paper pinned to cork.
Texture::Picture pinned_sheets(std::uint64_t seed);

}  // namespace aisle
