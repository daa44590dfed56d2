#include "cell_grid.hpp"

#include <algorithm>

namespace aisle {
namespace {

using Sums = std::vector<int>;  ///< of each channel over each cell of one row

void add_row(const std::uint8_t* pixels, const CellGrid& grid, int width_px, int channels, Sums& sums) {
  for (int column = 0; column < grid.columns; ++column) {
    const int end = std::min((column + 1) * grid.cell_px, width_px);
    for (int u = column * grid.cell_px; u < end; ++u)
      for (int c = 0; c < channels; ++c) sums[static_cast<std::size_t>(column * channels + c)] += *pixels++;
  }
}

CellLook look_of(const int* sums, int channels, int count) {
  const auto mean = [&](int c) { return sums[c] * kLookUnit / count; };
  if (channels == 1) return {mean(0), 0, 0};
  const int red = mean(0), green = mean(1), blue = mean(2);
  return {(5 * red + 9 * green + 2 * blue) / 16, red - green, (red + green) / 2 - blue};
}

}  // namespace

CellGrid cells_of(const Image& picture, int columns) {
  CellGrid grid;
  grid.cell_px = std::max(1, (picture.width_px + columns / 2) / columns);
  grid.columns = (picture.width_px + grid.cell_px - 1) / grid.cell_px;
  grid.rows = (picture.height_px + grid.cell_px - 1) / grid.cell_px;
  grid.looks.reserve(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  for (int row = 0; row < grid.rows; ++row) {
    Sums sums(static_cast<std::size_t>(grid.columns * picture.channels), 0);
    const int top = row * grid.cell_px, bottom = std::min(top + grid.cell_px, picture.height_px);
    for (int v = top; v < bottom; ++v)
      add_row(picture.row(v), grid, picture.width_px, picture.channels, sums);
    for (int column = 0; column < grid.columns; ++column) {
      const int left = column * grid.cell_px, right = std::min(left + grid.cell_px, picture.width_px);
      grid.looks.push_back(look_of(&sums[static_cast<std::size_t>(column * picture.channels)],
                                   picture.channels, (right - left) * (bottom - top)));
    }
  }
  return grid;
}

}  // namespace aisle
