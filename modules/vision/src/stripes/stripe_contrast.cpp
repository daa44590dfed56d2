#include "stripes/stripe_contrast.hpp"

#include <algorithm>
#include <utility>

namespace aisle {
namespace {

/// Row by row: target = the lesser (greater) of target and other.
template <class Pick>
void pick_into(std::uint8_t* target, const std::uint8_t* other, std::size_t count, Pick pick) {
  for (std::size_t i = 0; i < count; ++i) target[i] = pick(target[i], other[i]);
}

constexpr auto kLesser = [](std::uint8_t a, std::uint8_t b) { return a < b ? a : b; };
constexpr auto kGreater = [](std::uint8_t a, std::uint8_t b) { return a > b ? a : b; };

/// Each pixel becomes the least of itself and the `length - 1` pixels below it, as far as there are any.
/// Windows of doubled length are joined from two of the last ones.
void erode_downwards(Image& image, int length) {
  for (int have = 1; have < length;) {
    const int step = std::min(have, length - have);
    for (int v = 0; v + step < image.height_px; ++v)
      pick_into(image.row(v), image.row(v + step), image.row_bytes(), kLesser);
    have += step;
  }
}

/// Each pixel becomes the greatest of itself and the `length - 1` pixels above it, as far as there are any.
void dilate_upwards(Image& image, int length) {
  for (int have = 1; have < length;) {
    const int step = std::min(have, length - have);
    for (int v = image.height_px - 1; v >= step; --v)
      pick_into(image.row(v), image.row(v - step), image.row_bytes(), kGreater);
    have += step;
  }
}

/// What the opening by `length` pixels of a column takes away.
Image top_hat(const Image& grey, int length) {
  Image opened = grey;
  erode_downwards(opened, length);
  dilate_upwards(opened, length);
  for (std::size_t i = 0; i < grey.bytes.size(); ++i)
    opened.bytes[i] = static_cast<std::uint8_t>(grey.bytes[i] - opened.bytes[i]);
  return opened;
}

/// The strongest and the weakest channel of each pixel.
std::pair<Image, Image> channel_bounds(const Image& colour) {
  Image strongest(colour.width_px, colour.height_px), weakest(colour.width_px, colour.height_px);
  const std::uint8_t* rgb = colour.bytes.data();
  for (std::size_t i = 0; i < strongest.bytes.size(); ++i, rgb += 3) {
    strongest.bytes[i] = kGreater(kGreater(rgb[0], rgb[1]), rgb[2]);
    weakest.bytes[i] = kLesser(kLesser(rgb[0], rgb[1]), rgb[2]);
  }
  return {std::move(strongest), std::move(weakest)};
}

}  // namespace

Image stripe_contrast(const Image& image, int width_px, double white_share) {
  if (image.channels == 1) return top_hat(image, width_px);
  const auto [strongest, weakest] = channel_bounds(image);
  Image contrast = top_hat(strongest, width_px);
  const Image white = top_hat(weakest, width_px);
  const int white_256 = static_cast<int>(white_share * 256);
  for (std::size_t i = 0; i < contrast.bytes.size(); ++i) {
    const int left = contrast.bytes[i] - ((white.bytes[i] * white_256) >> 8);
    contrast.bytes[i] = static_cast<std::uint8_t>(std::max(left, 0));
  }
  return contrast;
}

}  // namespace aisle
