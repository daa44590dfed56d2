#pragma once

namespace aisle {

/// How a session keeps images.
struct ImageCoding {
  enum class Kind {
    kRaw,   ///< /camera/<name>/image_raw
    kJpeg,  ///< /camera/<name>/image_raw/compressed; loses a little, and the navigator sees what is kept
    kPng,   ///< /camera/<name>/image_raw/compressed
  };
  Kind kind = Kind::kJpeg;
  int jpeg_quality = 90;  ///< 1 to 100
};

}  // namespace aisle
