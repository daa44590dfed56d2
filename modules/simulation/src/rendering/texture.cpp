#include "rendering/texture.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

/// Pairs of columns become one.
Texture::Image half_as_wide(const Texture::Image& image) {
  Texture::Image half(image.size() / 2);
  for (std::size_t i = 0; i < half.size(); ++i) half[i] = (image[2 * i] + image[2 * i + 1]) / 2;
  return half;
}

/// Pairs of rows become one.
Texture::Image half_as_high(const Texture::Image& image, std::size_t width) {
  Texture::Image half(image.size() / 2);
  for (std::size_t i = 0; i < half.size(); ++i) {
    const std::size_t upper = i / width * 2 * width + i % width;
    half[i] = (image[upper] + image[upper + width]) / 2;
  }
  return half;
}

}  // namespace

Texture::Texture(const Image& image) : store_(std::size_t{4} * kSide * kSide) {
  Image high = image;
  for (int level_y = 0; level_y < kLevels; ++level_y) {
    Image wide = high;
    for (int level_x = 0; level_x < kLevels; ++level_x) {
      keep(wide, level_x, level_y);
      if (level_x + 1 < kLevels) wide = half_as_wide(wide);
    }
    if (level_y + 1 < kLevels) high = half_as_high(high, kSide);
  }
}

void Texture::keep(const Image& image, int level_x, int level_y) {
  const int width = kSide >> level_x, height = kSide >> level_y;
  const auto byte = [&](int x, int y) {
    const float value = image[static_cast<std::size_t>(y % height * width + x % width)];
    return static_cast<std::uint32_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      store_[static_cast<std::size_t>((level_begin(level_y) + y) * 2 * kSide + level_begin(level_x) + x)] =
          byte(x, y) | byte(x + 1, y) << 8 | byte(x, y + 1) << 16 | byte(x + 1, y + 1) << 24;
    }
  }
}

}  // namespace aisle
