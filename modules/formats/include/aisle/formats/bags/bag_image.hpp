#pragma once

#include <string>
#include <string_view>

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/bags/bag_message.hpp"

namespace aisle {

/// What a message shows.
struct BagImage {
  Image pixels;
  std::string file;  ///< the bytes of the image file that was sent; empty: pixels were
};

/// The image of a sensor_msgs/Image (encodings of 8 bits: mono8, rgb8, bgr8, rgba8, bgra8, yuyv, uyvy,
/// bayer_*8) or CompressedImage (JPEG, PNG). A compressed image's kind shows in its bytes; its format's name
/// is written in many ways.
/// @param type  of the message: "sensor_msgs/msg/Image"
Result<BagImage> bag_image(std::string_view bytes, const std::string& type, BagEncoding encoding,
                           const Place& place);

}  // namespace aisle
