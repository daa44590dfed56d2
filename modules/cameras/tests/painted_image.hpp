#pragma once
/// Images with a number painted in, which survives JPEG.

#include "aisle/core/image.hpp"

namespace aisle {

inline constexpr int kBlock_px = 16;
inline constexpr int kBits = 8;

/// A grey ramp below a row of blocks, which are the number's bits.
inline Image painted_image(int number, int height_px = 48) {
  Image image(kBits * kBlock_px, height_px);
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) {
      const bool bit = ((number >> (u / kBlock_px)) & 1) != 0;
      image.row(v)[u] = static_cast<std::uint8_t>(v < kBlock_px ? (bit ? 255 : 0) : u + v);
    }
  }
  return image;
}

inline int number_in(const Image& image) {
  int number = 0;
  for (int bit = 0; bit < kBits; ++bit) {
    const int u = bit * kBlock_px + kBlock_px / 2;
    if (image.row(kBlock_px / 2)[u * image.channels] > 127) number |= 1 << bit;
  }
  return number;
}

}  // namespace aisle
