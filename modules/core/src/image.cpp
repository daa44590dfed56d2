#include "aisle/core/image.hpp"

#include <algorithm>

namespace aisle {
namespace {

/// The pixels that pixel `i` of `count` covers, of `of` in all; at least one.
struct Covered {
  Covered(int i, int count, int of)
      : first(static_cast<int>(static_cast<long>(i) * of / count)),
        end(std::max(first + 1, static_cast<int>(static_cast<long>(i + 1) * of / count))) {}

  int first;
  int end;
};

}  // namespace

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

Image shrunk(const Image& image, int width_px, int height_px) {
  Image small(width_px, height_px, image.channels);
  for (int v = 0; v < small.height_px; ++v) {
    const Covered rows(v, small.height_px, image.height_px);
    for (int u = 0; u < small.width_px; ++u) {
      const Covered columns(u, small.width_px, image.width_px);
      const long count = static_cast<long>(rows.end - rows.first) * (columns.end - columns.first);
      for (int c = 0; c < image.channels; ++c) {
        long sum = 0;
        for (int y = rows.first; y < rows.end; ++y) {
          for (int x = columns.first; x < columns.end; ++x) sum += image.row(y)[x * image.channels + c];
        }
        small.row(v)[u * image.channels + c] = static_cast<std::uint8_t>(sum / count);
      }
    }
  }
  return small;
}

}  // namespace aisle
