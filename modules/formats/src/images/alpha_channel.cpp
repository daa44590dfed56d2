#include "images/alpha_channel.hpp"

#include <algorithm>

namespace aisle {
namespace {

constexpr std::uint8_t kOpaque = 255;

}  // namespace

TransparentImage apart_from_alpha(std::span<const std::uint8_t> pixels, int width_px, int height_px,
                                  int channels) {
  TransparentImage apart{Image(width_px, height_px, channels - 1), {}};
  const auto step = static_cast<std::size_t>(channels), colours = step - 1;
  std::vector<std::uint8_t> transparent(pixels.size() / step);
  for (std::size_t i = 0; i < transparent.size(); ++i) {
    std::copy_n(&pixels[i * step], colours, &apart.image.bytes[i * colours]);
    transparent[i] = pixels[i * step + colours] != kOpaque;
  }
  if (std::ranges::count(transparent, 1) > 0) apart.transparent = std::move(transparent);
  return apart;
}

std::vector<std::uint8_t> with_alpha(const Image& image, std::span<const std::uint8_t> transparent) {
  const auto colours = static_cast<std::size_t>(image.channels), step = colours + 1;
  std::vector<std::uint8_t> pixels(transparent.size() * step, kOpaque);
  for (std::size_t i = 0; i < transparent.size(); ++i) {
    std::copy_n(&image.bytes[i * colours], colours, &pixels[i * step]);
    if (transparent[i] != 0) pixels[i * step + colours] = 0;
  }
  return pixels;
}

}  // namespace aisle
