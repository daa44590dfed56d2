#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

/// Pictures of one drive side by side, with the vertical lines that were followed through them: the same line
/// in the same colour and with its number, a trail to where it was in the pictures before. Lines that are in
/// one picture alone are thin and grey.
class FollowedLinesSheet {
 public:
  /// @param pictures  how many there will be, at least 1
  explicit FollowedLinesSheet(std::size_t pictures);

  /// @param numbers  of `lines`, from 0; the same number is the same line
  void add(const Image& picture, const std::vector<VerticalLine>& lines, const std::vector<int>& numbers);

  /// @return a PNG file, at most 1800 px wide; at least one picture was added
  std::string png() const;

 private:
  class Sheet;
  struct Cell {
    Image picture;                    // as large as it is drawn
    std::vector<VerticalLine> lines;  // on it, from its corner
    std::vector<int> numbers;
  };

  std::size_t columns_;
  int width_max_px_;  // of a cell
  std::vector<Cell> cells_;
};

}  // namespace aisle
