#pragma once
/// A few bytes of JPEG can ask for gigabytes, and GStreamer's decoder gives them.

#include <gst/gst.h>

#include <optional>
#include <string_view>

namespace aisle {

struct JpegSize {
  int width_px = 0;
  int height_px = 0;
};

/// What the header of a JPEG says, as libjpeg reads it; nullopt: no size before the image's data.
std::optional<JpegSize> jpeg_size(std::string_view bytes);

/// From now on images larger than this are an error instead of being decoded, by whatever JPEG decoder the
/// pipeline has or gets.
void limit_jpeg_size(GstBin* pipeline, int side_max_px);

}  // namespace aisle
