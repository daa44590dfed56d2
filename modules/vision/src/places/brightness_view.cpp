#include "aisle/vision/places/brightness_view.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace aisle {
namespace {

/// Columns of the sums, about; noise of single columns does not decide.
constexpr int kSmoothing = 32;

/// From `u0`, `v0` to before `u1`, `v1`: brightest and darkest column.
std::array<double, 2> extremes(const Image& grey, int u0, int v0, int u1, int v1) {
  const int width = u1 - u0, reach = std::max(1, width / kSmoothing / 2);
  std::vector<long> sums(static_cast<std::size_t>(width) + 1, 0);  // running, over columns
  for (int u = 0; u < width; ++u) {
    long sum = 0;
    for (int v = v0; v < v1; ++v) sum += grey.row(v)[u0 + u];
    sums[static_cast<std::size_t>(u) + 1] = sums[static_cast<std::size_t>(u)] + sum;
  }
  const auto around = [&](int u) {
    const auto at = static_cast<std::size_t>(u), wide = static_cast<std::size_t>(reach);
    return sums[at + wide + 1] - sums[at - wide];
  };
  int brightest = reach, darkest = reach;
  for (int u = reach; u + reach < width; ++u) {
    if (around(u) > around(brightest)) brightest = u;
    if (around(u) < around(darkest)) darkest = u;
  }
  return {static_cast<double>(brightest) / width, static_cast<double>(darkest) / width};
}

}  // namespace

std::array<double, 8> brightness_view(const Image& image) {
  if (image.bytes.empty()) throw std::invalid_argument("a view needs an image");
  const Image grey = to_grey(image);
  const int w = grey.width_px, h = grey.height_px;
  const auto upper = extremes(grey, 0, 0, w, h / 2), lower = extremes(grey, 0, h / 2, w, h),
             left = extremes(grey, 0, 0, w / 2, h), right = extremes(grey, w / 2, 0, w, h);
  return {upper[0], upper[1], lower[0], lower[1], left[0], left[1], right[0], right[1]};
}

}  // namespace aisle
