#include "aisle/formats/images/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "images/image_codecs.hpp"
#include "images/image_damage.hpp"
#include "images/image_size.hpp"

namespace aisle {
namespace {

constexpr std::size_t kImageBytesMax = std::size_t{256} << 20;

/// Decoded to 8 bits, grey or colour as stored.
std::optional<TransparentImage> decode(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return decode_png(bytes);
  if (bytes.starts_with("\xff\xd8")) return decode_jpeg(bytes);
  if (bytes.starts_with("RIFF")) return decode_webp(bytes);
  return decode_by_pixbuf(bytes);
}

Problem no_image(const std::string& name) {
  return {{name}, "is not an image that can be read (PNG, JPEG, PBM, PGM, PPM, BMP, TIFF, WebP)"};
}

/// A few bytes may state a size whose pixels take all memory.
std::optional<Problem> refused_size(std::string_view bytes, const std::string& name) {
  const auto size = stated_image_size(bytes);
  if (!size) return no_image(name);
  const auto [width, height] = *size;
  if (std::max(width, height) <= kImageSideMax_px && width * height <= kImagePixelsMax) return std::nullopt;
  return Problem{{name},
                 fmt::format("has {} x {} pixels; at most {} a side and {} million in all are read", width,
                             height, kImageSideMax_px, kImagePixelsMax / 1'000'000)};
}

}  // namespace

Result<Image> read_image(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_whole_file(path, kImageBytesMax);
  if (!bytes) return bytes.problems();
  return parse_image(*bytes, path.string());
}

Result<Image> parse_image(std::string_view bytes, const std::string& name) {
  Result<TransparentImage> read = parse_transparent_image(bytes, name);
  if (!read) return read.problems();
  return std::move(read->image);
}

Result<TransparentImage> parse_transparent_image(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) return Problem{{name}, "is empty"};
  if (const auto damage = image_damage(bytes)) return Problem{{name}, *damage};
  if (auto problem = refused_size(bytes, name)) return *problem;
  std::optional<TransparentImage> decoded = decode(bytes);
  if (!decoded) return no_image(name);
  return std::move(*decoded);
}

std::string png_bytes(const Image& image) {
  return encode_png(image, {});
}

std::string png_bytes(const TransparentImage& image) {
  return encode_png(image.image, image.transparent);
}

std::string jpeg_bytes(const Image& image, int quality) {
  return encode_jpeg(image, quality);
}

}  // namespace aisle
