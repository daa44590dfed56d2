#include <png.h>

#include <memory>

#include "images/alpha_channel.hpp"
#include "images/image_codecs.hpp"

namespace aisle {
namespace {

png_image empty_png() {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  return png;
}

/// Alpha is the last channel, so that a format and its channels say the same.
png_uint_32 eight_bit_format(int colours, bool has_alpha) {
  if (colours == 1) return has_alpha ? PNG_FORMAT_GA : PNG_FORMAT_GRAY;
  return has_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
}

std::string encode(const void* pixels, const Image& image, bool has_alpha) {
  png_image png = empty_png();
  png.width = static_cast<png_uint_32>(image.width_px);
  png.height = static_cast<png_uint_32>(image.height_px);
  png.format = eight_bit_format(image.channels, has_alpha);
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  const int is_written = png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels, 0, nullptr);
  bytes.resize(is_written != 0 ? size : 0);
  return bytes;
}

}  // namespace

std::optional<TransparentImage> decode_png(std::string_view bytes) {
  png_image png = empty_png();
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&png, png_image_free);
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return std::nullopt;
  const bool has_alpha = (png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  const int colours = (png.format & PNG_FORMAT_FLAG_COLOR) != 0 ? 3 : 1;
  png.format = eight_bit_format(colours, has_alpha);
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits without a stated gamma are no other light than 8 bits
  const int width = static_cast<int>(png.width), height = static_cast<int>(png.height);
  Image pixels(width, height, colours + (has_alpha ? 1 : 0));
  if (png_image_finish_read(&png, nullptr, pixels.bytes.data(), 0, nullptr) == 0) return std::nullopt;
  if (!has_alpha) return TransparentImage{std::move(pixels), {}};
  return apart_from_alpha(pixels.bytes, width, height, pixels.channels);
}

std::string encode_png(const Image& image, std::span<const std::uint8_t> transparent) {
  if (transparent.empty()) return encode(image.bytes.data(), image, false);
  return encode(with_alpha(image, transparent).data(), image, true);
}

}  // namespace aisle
