#include <algorithm>
#include <cmath>

#include "aisle/vision/route/painted_frame.hpp"

namespace aisle {
namespace {

/// Grey levels along a row or a column of an image.
class GreyLine {
 public:
  GreyLine(const std::uint8_t* first, std::ptrdiff_t step, int count)
      : first_(first), step_(step), count_(count) {}

  int count() const { return count_; }
  double operator[](int i) const { return first_[i * step_]; }
  /// Where a level is passed between i and its neighbour at `step`.
  double crossing(int i, int step, double level) const {
    while (i + step >= 0 && i + step < count_ && (*this)[i + step] > level) i += step;
    if (i + step < 0 || i + step >= count_) return i;
    const double here = (*this)[i], there = (*this)[i + step];
    return i + step * (here - level) / std::max(1.0, here - there);
  }

 private:
  const std::uint8_t* first_;
  std::ptrdiff_t step_;
  int count_;
};

/// visit(position) for the middles of bright strips that are about as wide as expected.
template <class Width, class Visit>
void for_each_strip(const GreyLine& line, double contrast, const Width& width_px, const Visit& visit) {
  for (int i = 1; i + 1 < line.count(); ++i) {
    const double wide_px = width_px(i);
    const int off = std::max(2, static_cast<int>(std::lround(wide_px)));
    if (i < off || i + off >= line.count()) continue;
    const double beside = std::max(line[i - off], line[i + off]), top = line[i];
    if (top < beside * (1 + contrast)) continue;
    const double level = (top + beside) / 2;
    const double begin = line.crossing(i, -1, level), end = line.crossing(i, 1, level);
    const bool is_strip = end - begin < 2 * wide_px + 1 && end - begin > wide_px / 3;
    if (is_strip) visit((begin + end) / 2);
    i = std::max(i, static_cast<int>(std::ceil(end)));
  }
}

}  // namespace

std::vector<Vec2> painted_line_points(const Image& grey, const CameraModel& camera, const CameraMount& mount,
                                      const PaintedFrameParams& params) {
  constexpr int kStep = 4;  // of rows, columns
  const BackProjection floor(camera, mount, 0);
  std::vector<Vec2> points;
  const auto add = [&](double u, double v) {
    const auto p = floor.point({u, v});
    if (p && p->norm() < params.range_m) points.push_back(*p);
  };
  // How many pixels a line takes up in each row, across the row and along the column.
  std::vector<double> across_px(grey.rows(), 0), along_px(grey.rows(), 0);
  for (int v = 0; v < grey.height_px; ++v) {
    const double u = (grey.width_px - 1) / 2.0;
    const auto p = floor.point(Vec2(u, v)), beside = floor.point(Vec2(u + 1, v)),
               beyond = floor.point(Vec2(u, v - 1));
    if (!p || !beside || !beyond || p->norm() > params.range_m) continue;
    across_px[static_cast<std::size_t>(v)] = params.line_m / (*beside - *p).norm();
    along_px[static_cast<std::size_t>(v)] = params.line_m / (*beyond - *p).norm();
  }
  for (int v = 0; v < grey.height_px; v += kStep) {
    const double wide_px = across_px[static_cast<std::size_t>(v)];
    if (wide_px < 2) continue;
    for_each_strip(
        {grey.row(v), 1, grey.width_px}, params.contrast, [&](int) { return wide_px; },
        [&](double u) { add(u, v); });
  }
  for (int u = 0; u < grey.width_px; u += kStep) {
    for_each_strip(
        {grey.row(0) + u, static_cast<std::ptrdiff_t>(grey.row_bytes()), grey.height_px}, params.contrast,
        [&](int v) {
          const double wide_px = along_px[static_cast<std::size_t>(v)];
          return wide_px < 1.5 ? 1e6 : wide_px;
        },
        [&](double v) { add(u, v); });
  }
  return points;
}

}  // namespace aisle
