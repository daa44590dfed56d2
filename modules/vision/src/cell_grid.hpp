#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "aisle/core/image.hpp"

namespace aisle {

/// What a small square of a picture looks like: brightness, and colour as two differences of channels, all in
/// grey levels. A grey picture has no colour.
struct CellLook {
  int brightness = 0;
  int red_green = 0;
  int yellow_blue = 0;
};

/// A picture cut into square cells. Cells in the last row and column may be cut off.
struct CellGrid {
  int cell_px = 1;
  int columns = 0;
  int rows = 0;
  std::vector<CellLook> looks;  ///< row by row, in sixteenths of a grey level

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

constexpr int kLookUnit = 16;  ///< of CellGrid's looks in a grey level

/// The mean look of each cell; about `columns` cells in a row.
CellGrid cells_of(const Image& picture, int columns);

}  // namespace aisle
