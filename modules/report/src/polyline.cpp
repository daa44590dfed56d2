#include "polyline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/geometry/segment2.hpp"

namespace aisle {
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance) {
  if (points.size() < 3) return points;
  std::vector<char> is_kept(points.size(), 0);
  is_kept.front() = is_kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double farthest_off = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = Segment2{points[first], points[last]}.distance(points[i]);
      if (off > farthest_off) {
        farthest = i;
        farthest_off = off;
      }
    }
    if (farthest == first) continue;
    is_kept[farthest] = 1;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_kept[i] != 0) kept.push_back(points[i]);
  }
  return kept;
}

std::vector<Vec2> points_on(const Path& path) {
  constexpr double kStep_m = 0.05;
  std::vector<Vec2> points;
  for (const PathPiece& piece : path.pieces()) {
    const double path_m = piece.path_m();
    const int steps = std::max(1, static_cast<int>(std::ceil(path_m / kStep_m)));
    for (int i = 0; i <= steps; ++i) points.push_back(piece.at(path_m * i / steps).position());
  }
  return points;
}

}  // namespace aisle
