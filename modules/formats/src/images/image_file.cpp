#include "aisle/formats/images/image_file.hpp"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "images/image_damage.hpp"

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

std::string encoded(const Image& image, const char* extension, const std::vector<int>& settings) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, to_mat(image), bytes, settings);
  return {bytes.begin(), bytes.end()};
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

}  // namespace

Result<Image> read_image(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_whole_file(path, kImageBytesMax);
  if (!bytes) return bytes.problems();
  return parse_image(*bytes, path.string());
}

Result<Image> parse_image(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) return Problem{{name}, "is empty"};
  if (const auto damage = image_damage(bytes)) return Problem{{name}, *damage};
  const cv::Mat decoded = decode(bytes);
  if (decoded.empty())
    return Problem{{name}, "is not an image that can be read (PNG, JPEG, PGM, PPM, BMP, TIFF)"};
  if (decoded.cols > kImageSideMax_px || decoded.rows > kImageSideMax_px) {
    return Problem{{name},
                   fmt::format("has {} x {} pixels; at most {} a side are read", decoded.cols, decoded.rows,
                               kImageSideMax_px)};
  }
  cv::Mat pixels = decoded;
  if (decoded.channels() == 3) cv::cvtColor(decoded, pixels, cv::COLOR_BGR2RGB);
  Image image(pixels.cols, pixels.rows, pixels.channels());
  for (int v = 0; v < pixels.rows; ++v) std::copy_n(pixels.ptr(v), image.row_bytes(), image.row(v));
  return image;
}

std::string png_bytes(const Image& image) {
  return encoded(image, ".png", {cv::IMWRITE_PNG_COMPRESSION, 3});
}

std::string jpeg_bytes(const Image& image, int quality) {
  return encoded(image, ".jpg", {cv::IMWRITE_JPEG_QUALITY, quality});
}

}  // namespace aisle
