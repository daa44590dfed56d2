#include "route/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

template <int kChannels>
void add_row(const std::uint8_t* pixels, const CellGrid& grid, int width_px, std::vector<int>& sums) {
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

void CellGrid::take(const Image& image, int about_columns) {
  cell_px = std::max(1, (image.width_px + about_columns / 2) / about_columns);
  columns = (image.width_px + cell_px - 1) / cell_px;
  rows = (image.height_px + cell_px - 1) / cell_px;
  looks.clear();
  looks.reserve(index(rows, 0));
  for (int row = 0; row < rows; ++row) {
    sums_.assign(static_cast<std::size_t>(columns * image.channels), 0);
    const int top = row * cell_px, bottom = std::min(top + cell_px, image.height_px);
    for (int v = top; v < bottom; ++v) {
      if (image.channels == 1)
        add_row<1>(image.row(v), *this, image.width_px, sums_);
      else
        add_row<3>(image.row(v), *this, image.width_px, sums_);
    }
    for (int column = 0; column < columns; ++column) {
      const int width = std::min(cell_px, image.width_px - column * cell_px);
      looks.push_back(look_of(&sums_[static_cast<std::size_t>(column * image.channels)], image.channels,
                              width * (bottom - top)));
    }
  }
}

}  // namespace aisle
