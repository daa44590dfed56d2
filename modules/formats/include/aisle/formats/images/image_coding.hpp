#pragma once

namespace aisle {

/// How a session stores images.
struct ImageCoding {
  enum class Kind {
    kRaw,   ///< `/camera/NAME/image_raw`
    kJpeg,  ///< `/camera/NAME/image_raw/compressed`; lossy, and the navigator sees the decoded image
    kPng,   ///< `/camera/NAME/image_raw/compressed`
  };
  Kind kind = Kind::kJpeg;
  int jpeg_quality = 90;  ///< 1 to 100
};

}  // namespace aisle
