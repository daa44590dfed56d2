#pragma once
/// Image files in memory, each format by the library that its own people keep.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "aisle/formats/images/image_file.hpp"

namespace aisle {

/// Decoders take files whose stated size has been checked. Nothing: the file cannot be decoded.
std::optional<TransparentImage> decode_png(std::string_view bytes);
std::optional<TransparentImage> decode_jpeg(std::string_view bytes);
std::optional<TransparentImage> decode_webp(std::string_view bytes);
/// BMP, TIFF and Netpbm. An image without any colour is grey.
std::optional<TransparentImage> decode_by_pixbuf(std::string_view bytes);

/// @param transparent  one a pixel; empty: the file has no alpha channel
std::string encode_png(const Image& image, std::span<const std::uint8_t> transparent);
/// @param quality  1 to 100
std::string encode_jpeg(const Image& image, int quality);

}  // namespace aisle
