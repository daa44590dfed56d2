#include "shrunk_picture.hpp"

#include <algorithm>

namespace aisle {
namespace {

/// The pixels that pixel `i` of `count` covers, of `of` in all; at least one.
struct Covered {
  Covered(int i, int count, int of)
      : first(static_cast<int>(static_cast<long>(i) * of / count)),
        end(std::max(first + 1, static_cast<int>(static_cast<long>(i + 1) * of / count))) {}

  int first;
  int end;
};

}  // namespace

Image shrunk(const Image& picture, double scale) {
  Image small(std::max(1, static_cast<int>(scale * picture.width_px)),
              std::max(1, static_cast<int>(scale * picture.height_px)), picture.channels);
  for (int v = 0; v < small.height_px; ++v) {
    const Covered rows(v, small.height_px, picture.height_px);
    for (int u = 0; u < small.width_px; ++u) {
      const Covered columns(u, small.width_px, picture.width_px);
      for (int c = 0; c < picture.channels; ++c) {
        int sum = 0;
        for (int y = rows.first; y < rows.end; ++y) {
          for (int x = columns.first; x < columns.end; ++x) sum += picture.row(y)[x * picture.channels + c];
        }
        small.row(v)[u * picture.channels + c] =
            static_cast<std::uint8_t>(sum / ((rows.end - rows.first) * (columns.end - columns.first)));
      }
    }
  }
  return small;
}

}  // namespace aisle
