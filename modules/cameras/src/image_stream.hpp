#pragma once

#include <string>
#include <variant>

#include "aisle/core/image.hpp"

namespace aisle {

struct NothingYet {};

struct StreamedImage {
  Image pixels;
  double stamp_s = 0;  ///< by SteadyClock
};

struct RefusedImage {
  std::string why;
};

struct StreamEnd {
  std::string why;
  bool is_final = false;  ///< all was shown: opening it again makes no sense
};

using StreamNews = std::variant<NothingYet, StreamedImage, RefusedImage, StreamEnd>;

/// Images from one opening of a source.
class ImageStream {
 public:
  virtual ~ImageStream() = default;

  /// To be called once, before waiting.
  virtual void start() = 0;

  /// The next news; after StreamEnd there is none.
  virtual StreamNews wait(double longest_s) = 0;
};

}  // namespace aisle
