#include "aisle/formats/images/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "images/image_damage.hpp"
#include "images/image_size.hpp"
#include "images/image_transparency.hpp"

namespace aisle {
namespace {

constexpr std::size_t kImageBytesMax = std::size_t{256} << 20;

/// The image in OpenCV's channel order.
cv::Mat to_mat(const Image& image) {
  cv::Mat pixels(image.height_px, image.width_px, image.channels == 3 ? CV_8UC3 : CV_8UC1,
                 const_cast<std::uint8_t*>(image.bytes.data()));  // NOLINT: only read
  if (image.channels == 1) return pixels;
  cv::Mat bgr;
  cv::cvtColor(pixels, bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

std::string encoded(const cv::Mat& image, const char* extension, const std::vector<int>& settings) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, image, bytes, settings);
  return {bytes.begin(), bytes.end()};
}

std::string encoded_png(const cv::Mat& image) {
  return encoded(image, ".png", {cv::IMWRITE_PNG_COMPRESSION, 3});
}

/// Decoded to 8 bits, grey or colour as stored.
cv::Mat decode(std::string_view bytes) {
  const cv::Mat file(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));  // NOLINT
  try {
    return cv::imdecode(file, cv::IMREAD_ANYCOLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    return {};
  }
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
  if (bytes.empty()) return Problem{{name}, "is empty"};
  if (const auto damage = image_damage(bytes)) return Problem{{name}, *damage};
  if (auto problem = refused_size(bytes, name)) return *problem;
  const cv::Mat decoded = decode(bytes);
  if (decoded.empty()) return no_image(name);
  cv::Mat pixels = decoded;
  if (decoded.channels() == 3) cv::cvtColor(decoded, pixels, cv::COLOR_BGR2RGB);
  Image image(pixels.cols, pixels.rows, pixels.channels());
  for (int v = 0; v < pixels.rows; ++v) std::copy_n(pixels.ptr(v), image.row_bytes(), image.row(v));
  return image;
}

Result<TransparentImage> parse_transparent_image(std::string_view bytes, const std::string& name) {
  Result<Image> image = parse_image(bytes, name);
  if (!image) return image.problems();
  TransparentImage read{std::move(*image), transparent_pixels(bytes)};
  if (!read.transparent.empty() &&
      read.transparent.size() != read.image.rows() * static_cast<std::size_t>(read.image.width_px))
    return Problem{{name}, "has a transparency that cannot be read"};
  return read;
}

std::string png_bytes(const Image& image) {
  return encoded_png(to_mat(image));
}

std::string png_bytes(const TransparentImage& image) {
  cv::Mat with_alpha;
  cv::cvtColor(to_mat(image.image), with_alpha,
               image.image.channels == 1 ? cv::COLOR_GRAY2BGRA : cv::COLOR_BGR2BGRA);
  for (std::size_t i = 0; i < image.transparent.size(); ++i) {
    if (image.transparent[i] != 0) with_alpha.data[4 * i + 3] = 0;
  }
  return encoded_png(with_alpha);
}

std::string jpeg_bytes(const Image& image, int quality) {
  return encoded(to_mat(image), ".jpg", {cv::IMWRITE_JPEG_QUALITY, quality});
}

}  // namespace aisle
