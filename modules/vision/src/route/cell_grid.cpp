#include "route/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

/// Sums of each channel over the cells of one row, of the tones of its pixels' rows.
using Sums = std::vector<int>;

template <int kChannels>
void add_row(const std::uint8_t* pixels, const CellGrid& grid, int width_px, Sums& sums) {
  int* sum = sums.data();
  for (int column = 0; column < grid.columns; ++column, sum += kChannels) {
    const int count = std::min(grid.cell_px, width_px - column * grid.cell_px);
    int cell[kChannels] = {};
    for (int u = 0; u < count; ++u)
      for (int c = 0; c < kChannels; ++c) cell[c] += *pixels++;
    for (int c = 0; c < kChannels; ++c) sum[c] += cell[c];
  }
}

/// The tone of a mean of `count` grey values, in look units.
int tone(int sum, int count) {
  const double share = sum / (255.0 * count);
  return static_cast<int>(255 * kLookUnit * std::sqrt(share));
}

CellLook look_of(const int* sums, int channels, int count) {
  if (channels == 1) return {tone(sums[0], count), 0, 0};
  const int red = tone(sums[0], count), green = tone(sums[1], count), blue = tone(sums[2], count);
  return {(5 * red + 9 * green + 2 * blue) / 16, red - green, (red + green) / 2 - blue};
}

}  // namespace

CellGrid cells_of(const Image& picture, int columns) {
  CellGrid grid;
  grid.cell_px = std::max(1, (picture.width_px + columns / 2) / columns);
  grid.columns = (picture.width_px + grid.cell_px - 1) / grid.cell_px;
  grid.rows = (picture.height_px + grid.cell_px - 1) / grid.cell_px;
  grid.looks.reserve(grid.index(grid.rows, 0));
  for (int row = 0; row < grid.rows; ++row) {
    Sums sums(static_cast<std::size_t>(grid.columns * picture.channels), 0);
    const int top = row * grid.cell_px, bottom = std::min(top + grid.cell_px, picture.height_px);
    for (int v = top; v < bottom; ++v) {
      if (picture.channels == 1)
        add_row<1>(picture.row(v), grid, picture.width_px, sums);
      else
        add_row<3>(picture.row(v), grid, picture.width_px, sums);
    }
    for (int column = 0; column < grid.columns; ++column) {
      const int width = std::min(grid.cell_px, picture.width_px - column * grid.cell_px);
      grid.looks.push_back(look_of(&sums[static_cast<std::size_t>(column * picture.channels)],
                                   picture.channels, width * (bottom - top)));
    }
  }
  return grid;
}

}  // namespace aisle
