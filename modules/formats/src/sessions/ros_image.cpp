#include "sessions/ros_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "field_reader.hpp"
#include "file_limits.hpp"

namespace aisle {
namespace {

struct PixelEncoding {
  std::string_view name;
  int pixel_bytes = 1;
  std::optional<int> conversion =
      {};            ///< OpenCV's, to red, green, blue; none: the bytes are as they should be
  int block_px = 1;  ///< both sides have at least so many pixels, the width whole blocks
};

/// OpenCV names a Bayer pattern by its second row and column, ROS by its first.
constexpr std::array<PixelEncoding, 15> kEncodings = {{{"mono8"},
                                                       {"8UC1"},
                                                       {"rgb8", 3},
                                                       {"bgr8", 3, cv::COLOR_BGR2RGB},
                                                       {"8UC3", 3, cv::COLOR_BGR2RGB},
                                                       {"rgba8", 4, cv::COLOR_RGBA2RGB},
                                                       {"bgra8", 4, cv::COLOR_BGRA2RGB},
                                                       {"yuyv", 2, cv::COLOR_YUV2RGB_YUY2, 2},
                                                       {"yuv422_yuy2", 2, cv::COLOR_YUV2RGB_YUY2, 2},
                                                       {"uyvy", 2, cv::COLOR_YUV2RGB_UYVY, 2},
                                                       {"yuv422", 2, cv::COLOR_YUV2RGB_UYVY, 2},
                                                       {"bayer_rggb8", 1, cv::COLOR_BayerBG2RGB, 2},
                                                       {"bayer_bggr8", 1, cv::COLOR_BayerRG2RGB, 2},
                                                       {"bayer_gbrg8", 1, cv::COLOR_BayerGR2RGB, 2},
                                                       {"bayer_grbg8", 1, cv::COLOR_BayerGB2RGB, 2}}};

/// Whether the message's rows are in its bytes; all sizes are bounded by them.
bool has_its_pixels(const ros::Image& message, const PixelEncoding& encoding) {
  const std::uint32_t block = static_cast<std::uint32_t>(encoding.block_px);
  return std::cmp_less_equal(std::max(message.width, message.height), kImageSideMax_px) &&
         std::min(message.width, message.height) >= block && message.width % block == 0 &&
         message.step >= message.width * static_cast<std::uint32_t>(encoding.pixel_bytes) &&
         message.data.size() >= std::size_t{message.step} * message.height;
}

Problem unread_encoding(const std::string& encoding, const Place& place) {
  std::string read;
  for (const PixelEncoding& known : kEncodings)
    read += fmt::format("{}{}", read.empty() ? "" : ", ", known.name);
  return {place, fmt::format("has images in '{}'; {} are read", printable(encoding), read)};
}

}  // namespace

Result<Image> image_of(const ros::Image& message, const Place& place) {
  const auto encoding = std::find_if(kEncodings.begin(), kEncodings.end(), [&](const PixelEncoding& known) {
    return known.name == message.encoding;
  });
  if (encoding == kEncodings.end()) return unread_encoding(message.encoding, place);
  if (!has_its_pixels(message, *encoding)) {
    return Problem{place, fmt::format("has an image of {} x {} pixels in rows of {} bytes, with {} bytes",
                                      message.width, message.height, message.step, message.data.size())};
  }
  const int width_px = static_cast<int>(message.width), height_px = static_cast<int>(message.height);
  const int channels = encoding->pixel_bytes == 1 && !encoding->conversion ? 1 : 3;
  Image image(width_px, height_px, channels);
  const cv::Mat bytes(height_px, width_px, CV_8UC(encoding->pixel_bytes),
                      const_cast<std::uint8_t*>(message.data.data()), message.step);  // NOLINT: only read
  cv::Mat pixels(height_px, width_px, CV_8UC(channels), image.bytes.data());
  if (encoding->conversion) {
    cv::cvtColor(bytes, pixels, *encoding->conversion);
  } else {
    bytes.copyTo(pixels);
  }
  return image;
}

}  // namespace aisle
