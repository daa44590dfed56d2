#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aisle {

/// An image: rows from the top, each pixel its channels in turn. Pixel (0, 0) is the CENTRE of the top-left
/// pixel, u to the right, v down.
struct Image {
  int width_px = 0;
  int height_px = 0;
  int channels = 1;  ///< 1: grey; 3: red, green, blue
  std::vector<std::uint8_t> bytes;

  Image() = default;
  Image(int width, int height, int channel_count = 1)
      : width_px(width), height_px(height), channels(channel_count), bytes(row_bytes() * rows()) {}

  std::size_t row_bytes() const {
    return static_cast<std::size_t>(width_px) * static_cast<std::size_t>(channels);
  }
  std::size_t rows() const { return static_cast<std::size_t>(height_px); }
  const std::uint8_t* row(int v) const { return bytes.data() + static_cast<std::size_t>(v) * row_bytes(); }
  std::uint8_t* row(int v) { return bytes.data() + static_cast<std::size_t>(v) * row_bytes(); }

  friend bool operator==(const Image&, const Image&) = default;
};

/// The image in grey (ITU-R BT.601 weights, rounded); a grey image is returned unchanged.
Image to_grey(const Image& image);
/// The same, but a grey image is not copied. @return `image` or `converted`
const Image& as_grey(const Image& image, Image& converted);

/// The image in another size, at least 1 x 1, each pixel the mean of those it covers.
/// @param image  not empty
Image shrunk(const Image& image, int width_px, int height_px);

}  // namespace aisle
