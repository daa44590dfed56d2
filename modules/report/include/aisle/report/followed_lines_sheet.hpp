#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

/// Images of one drive side by side, with the vertical lines that were tracked through them. A line keeps its
/// colour and number, and has a trail to its position in the images before. Lines seen in one image only are
/// thin and grey.
class FollowedLinesSheet {
 public:
  /// @param images  how many images there will be, at least 1
  explicit FollowedLinesSheet(std::size_t images);

  /// @param numbers  of `lines`, from 0; equal numbers mean the same line
  void add(const Image& image, const std::vector<VerticalLine>& lines, const std::vector<int>& numbers);

  /// Needs at least one image. @return a PNG file, at most 1800 px wide
  std::string png() const;

 private:
  class Sheet;
  struct Cell {
    Image image;                      // in the size in which it is drawn
    std::vector<VerticalLine> lines;  // in that size's pixels, from its corner
    std::vector<int> numbers;
  };

  std::size_t columns_;
  int width_max_px_;  // of a cell
  std::vector<Cell> cells_;
};

}  // namespace aisle
