#pragma once

#include <cstddef>
#include <vector>

#include "aisle/core/image.hpp"

namespace aisle {

/// What a small square of an image looks like, in sixteenths of a grey level on the tone scale
/// 255 sqrt(g / 255). A grey image has no colour.
struct CellLook {
  int brightness = 0;
  int red_green = 0;    ///< red less green
  int yellow_blue = 0;  ///< the mean of red and green less blue
};

constexpr int kLookUnit = 16;  ///< of a CellLook, in a grey level

/// An image cut into square cells. Cells of the last row and column may be cut off. Keeps its memory from
/// image to image.
struct CellGrid {
  int cell_px = 1;
  int columns = 0;
  int rows = 0;
  std::vector<CellLook> looks;  ///< row by row: the mean look of each cell

  /// @param about_columns  cells in a row
  void take(const Image& image, int about_columns);

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }

 private:
  std::vector<int> sums_;  // of each channel over the cells of one row
};

/// Some neighbouring cells.
struct CellBlock {
  int first_row = 0, end_row = 0;
  int first_column = 0, end_column = 0;

  bool contains(int row, int column) const {
    return row >= first_row && row < end_row && column >= first_column && column < end_column;
  }
};

}  // namespace aisle
