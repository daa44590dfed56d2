#pragma once

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/ros_messages.hpp"

namespace aisle {

/// The pixels of a message, grey or colour. Read are the encodings of 8 bits: mono8, rgb8, bgr8, rgba8,
/// bgra8, 8UC1, 8UC3 (as bgr8), yuyv, uyvy, bayer_*8. Another one is a problem that names it, and so is a
/// message whose size does not fit its bytes.
Result<Image> image_of(const ros::Image& message, const Place& place);

}  // namespace aisle
