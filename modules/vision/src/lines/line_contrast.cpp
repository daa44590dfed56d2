#include "lines/line_contrast.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

namespace {

constexpr double kBeside = 2.0 / 640;  // contrast is measured this share of the width to either side

}  // namespace

double u_at(const VerticalLine& line, double v_px) {
  const Vec2 down = line.bottom_px - line.top_px;
  return line.top_px.x() + down.x() / down.y() * (v_px - line.top_px.y());
}

double contrast_between(const Image& grey, const VerticalLine& line, double top_px, double bottom_px) {
  const int beside_px = std::max(1, static_cast<int>(std::lround(kBeside * grey.width_px)));
  const int first = std::max(0, static_cast<int>(std::ceil(top_px)));
  const int last = std::min(grey.height_px - 1, static_cast<int>(bottom_px));
  double sum = 0;
  int count = 0;
  for (int v = first; v <= last; ++v) {
    const int u = static_cast<int>(std::lround(u_at(line, v)));
    if (u - beside_px < 0 || u + beside_px >= grey.width_px) continue;
    sum += grey.row(v)[u + beside_px] - grey.row(v)[u - beside_px];
    ++count;
  }
  return count == 0 ? 0 : std::copysign(1.0, line.contrast) * sum / count;
}

}  // namespace aisle
