#pragma once

#include <array>
#include <string>
#include <string_view>

#include "aisle/core/parameters.hpp"

namespace aisle {

/// Where the images of a camera come from that no robot's driver delivers. Exactly one of the four texts is
/// given.
struct CameraSource {
  std::string device;  ///< a camera of this machine: "/dev/video0"
  /// A network camera: "rtsp://..." ("rtspt://...": by TCP alone), "http://..." or "https://..." with MJPEG.
  /// May begin with USER:PASSWORD@, which no message shows.
  std::string url;
  std::string folder;  ///< replayed: image files, or another recording that aisle import reads
  /// In the words of gst-launch-1.0, ending in video: what none of the others can do. It is code: only from
  /// the user's own files.
  std::string pipeline;

  bool is_colour = false;
  int width_px = 0;   ///< of every image: others are refused, and a device is asked for it
  int height_px = 0;  ///< 0, like the width: as the first image has it
  int latency_ms = 0;
  double exposure_offset_s = 0;
  double silent_max_s = 2;
  double rate_hz = 10;
  bool loops = false;

  struct Origin {
    std::string_view key;
    std::string* text;
  };
  /// The four texts; valid as long as this object lives.
  std::array<Origin, 4> origins();

  /// Everything but the four texts.
  void describe(FieldList& fields);

  /// What keeps the source from being opened; each names its key.
  Problems problems() const;
};

}  // namespace aisle
