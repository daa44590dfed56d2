#pragma once
/// Image files: PNG, JPEG, WebP, BMP, TIFF and Netpbm (PBM, PGM, PPM).

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// Grey images get one channel, colour images three; 16 bits are reduced to 8, transparency is dropped, and
/// the EXIF orientation tag is ignored. A BMP, TIFF or PPM without any colour is grey. A file that is not an
/// image, is truncated, or has more than 16384 columns or rows or 33 million pixels is a problem.
Result<Image> read_image(const std::filesystem::path& path);

/// The same from memory; `name` is the file name in problems.
Result<Image> parse_image(std::string_view bytes, const std::string& name);

/// An image and what shows through it.
struct TransparentImage {
  Image image;
  std::vector<std::uint8_t> transparent;  ///< one a pixel, 1: not wholly opaque; empty: all are opaque
};

/// The same with its transparency: the alpha channel of a PNG, TIFF or WebP, or the tRNS colour of a PNG.
Result<TransparentImage> parse_transparent_image(std::string_view bytes, const std::string& name);

/// The image as a PNG file.
std::string png_bytes(const Image& image);
/// The same with an alpha channel: transparent pixels are wholly so.
std::string png_bytes(const TransparentImage& image);

/// The image as a JPEG file. @param quality  1 to 100
std::string jpeg_bytes(const Image& image, int quality);

}  // namespace aisle
