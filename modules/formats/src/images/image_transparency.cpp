#include "images/image_transparency.hpp"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "images/big_endian.hpp"

namespace aisle {
namespace {

constexpr std::string_view kPngStart("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t kFirstChunkAt = 8, kChunkHead = 8, kChunkFrame = 12;
constexpr std::size_t kBitDepthAt = 24, kColourTypeAt = 25;

bool may_have_alpha(std::string_view bytes) {
  using namespace std::string_view_literals;
  const bool is_tiff = bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv);
  const bool is_webp = bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP");
  return bytes.starts_with(kPngStart) || is_tiff || is_webp;
}

/// The grey that a grey PNG declares transparent, at its own bit depth. OpenCV knows tRNS of other PNGs only.
std::optional<unsigned> transparent_grey(std::string_view png) {
  if (!png.starts_with(kPngStart) || png.size() <= kColourTypeAt || png[kColourTypeAt] != 0)
    return std::nullopt;
  for (std::size_t at = kFirstChunkAt; at + kChunkFrame <= png.size();) {
    const std::size_t length = big_endian(png.substr(at));
    const std::string_view type = png.substr(at + 4, 4);
    if (type == "IDAT" || type == "IEND" || length > png.size() - at - kChunkFrame) return std::nullopt;
    if (type == "tRNS" && length == 2) return big_endian(png.substr(at + kChunkHead)) >> 16;
    at += kChunkFrame + length;
  }
  return std::nullopt;
}

cv::Mat where_grey(const cv::Mat& decoded, unsigned grey, unsigned bit_depth) {
  const unsigned scale = bit_depth < 8 ? 255 / ((1U << bit_depth) - 1) : 1;
  return decoded == static_cast<double>(grey * scale);
}

cv::Mat where_alpha(const cv::Mat& decoded) {
  cv::Mat alpha;
  cv::extractChannel(decoded, alpha, 3);
  return alpha < (alpha.depth() == CV_8U ? 255.0 : 65535.0);
}

}  // namespace

std::vector<std::uint8_t> transparent_pixels(std::string_view bytes) {
  if (!may_have_alpha(bytes)) return {};
  const auto grey = transparent_grey(bytes);
  const cv::Mat file(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));  // NOLINT
  cv::Mat marks;
  try {
    const cv::Mat decoded = cv::imdecode(file, cv::IMREAD_UNCHANGED);
    if (decoded.channels() == 4 && decoded.depth() <= CV_16U) marks = where_alpha(decoded);
    if (grey && decoded.channels() == 1)
      marks = where_grey(decoded, *grey, static_cast<unsigned char>(bytes[kBitDepthAt]));
  } catch (const cv::Exception&) {
    return {};
  }
  if (marks.empty() || cv::countNonZero(marks) == 0) return {};
  std::vector<std::uint8_t> transparent(marks.begin<std::uint8_t>(), marks.end<std::uint8_t>());
  for (std::uint8_t& mark : transparent) mark = mark != 0;
  return transparent;
}

}  // namespace aisle
