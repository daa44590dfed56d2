#include "debian_package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace aisle {
namespace {

/// What Debian 12 packs where, by the beginnings of the elements' names: those that aisle uses, and what
/// users write in pipelines for cameras.
struct PackedElements {
  std::string_view package;
  std::array<std::string_view, 16> names;
};

constexpr std::array<PackedElements, 5> kPackages = {{
    {"libgstreamer1.0-0", {"capsfilter", "identity", "queue", "filesrc", "tee", "fdsrc"}},
    {"gstreamer1.0-plugins-base",
     {"app", "decodebin", "uridecodebin", "parsebin", "videoconvert", "videoscale", "videorate",
      "videotestsrc", "tcp", "theora", "ogg", "vorbis", "ximage"}},
    {"gstreamer1.0-plugins-good",
     {"v4l2", "souphttp", "multipart", "multifile", "jpeg", "png", "rtsp", "rtp", "udp", "vp8", "vp9",
      "videocrop", "videoflip", "matroska", "qtdemux", "ximagesrc"}},
    {"gstreamer1.0-plugins-bad",
     {"h264parse", "h265parse", "openh264", "mpegvideoparse", "jpegparse", "tsdemux", "hls", "dash", "srt",
      "rtmp", "webrtc", "va", "nv", "kms", "curl", "sdp"}},
    {"gstreamer1.0-libav", {"av"}},
}};

std::string_view package_of(std::string_view element) {
  for (const PackedElements& packed : kPackages) {
    if (std::any_of(packed.names.begin(), packed.names.end(),
                    [&](std::string_view name) { return !name.empty() && element.starts_with(name); }))
      return packed.package;
  }
  return {};
}

}  // namespace

std::string how_to_install(std::string_view element) {
  const std::string_view package = package_of(element);
  if (!package.empty()) {
    return fmt::format("needs GStreamer's element {}, which is not installed: apt-get install {}", element,
                       package);
  }
  return fmt::format("needs an element {}, which GStreamer does not have here and aisle does not know",
                     element);
}

}  // namespace aisle
