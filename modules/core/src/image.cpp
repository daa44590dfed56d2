#include "aisle/core/image.hpp"

namespace aisle {

Image to_grey(const Image& image) {
  if (image.channels == 1) return image;
  Image grey(image.width_px, image.height_px);
  // 0.299, 0.587 and 0.114 in 16-bit fixed point; they add up to exactly 1.
  constexpr std::uint32_t kRed = 19595, kGreen = 38470, kBlue = 7471, kHalf = 1U << 15;
  for (std::size_t i = 0; i < grey.bytes.size(); ++i) {
    const std::uint8_t* rgb = image.bytes.data() + 3 * i;
    grey.bytes[i] =
        static_cast<std::uint8_t>((kRed * rgb[0] + kGreen * rgb[1] + kBlue * rgb[2] + kHalf) >> 16);
  }
  return grey;
}

const Image& as_grey(const Image& image, Image& converted) {
  if (image.channels == 1) return image;
  return converted = to_grey(image);
}

}  // namespace aisle
