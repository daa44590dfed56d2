#pragma once

#include <gif_lib.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace aisle {

/// An animation of few colours as a GIF file that repeats for ever.
class GifAnimation {
 public:
  using Palette = std::array<GifColorType, 8>;

  GifAnimation(int width, int height, const Palette& palette);
  ~GifAnimation();
  GifAnimation(const GifAnimation&) = delete;
  GifAnimation& operator=(const GifAnimation&) = delete;

  /// @param pixels  palette indices, row by row from the top
  void add_frame(const std::vector<std::uint8_t>& pixels, int hundredths_s);
  /// The file. No frame can be added afterwards.
  std::string finish();

 private:
  struct Box {
    int left, top, right, bottom;  ///< right and bottom are the first outside
  };

  Box changed_box(const std::vector<std::uint8_t>& pixels) const;
  void begin_loop();
  void require(int gif_result) const;

  int width_;
  int height_;
  std::string bytes_;
  GifFileType* file_ = nullptr;
  std::vector<std::uint8_t> shown_;
};

}  // namespace aisle
