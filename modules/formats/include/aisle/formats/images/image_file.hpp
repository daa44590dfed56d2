#pragma once
/// Images as files: PNG, JPEG, PPM, PGM, BMP, TIFF, as the image library reads them.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// As stored: grey images have one channel, colour ones three; 16 bits are brought to 8, transparency is
/// dropped, a camera's turning tag is not applied. A file that is no image, is cut off, or has more than
/// 16384 columns or rows is a problem.
Result<Image> read_image(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in problems.
Result<Image> parse_image(std::string_view bytes, const std::string& name);

/// A PNG file.
std::string png_bytes(const Image& image);

/// A JPEG file. @param quality  1 to 100
std::string jpeg_bytes(const Image& image, int quality);

}  // namespace aisle
